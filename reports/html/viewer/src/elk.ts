/** elkjs, in a worker, or where there can be none on this thread. */
import ELK, { type ElkExtendedEdge, type ElkNode, type LayoutOptions } from "elkjs/lib/elk-api";
import { unpack } from "./data";

export interface Point {
  x: number;
  y: number;
}

export interface Rectangle extends Point {
  width: number;
  height: number;
}

type Elk = InstanceType<typeof ELK>;

let running: Promise<Elk> | null = null;

export async function arrange(graph: ElkNode, layoutOptions: LayoutOptions): Promise<ElkNode> {
  running ??= start();
  return (await running).layout(graph, { layoutOptions });
}

/** The points that a line leads through. */
export function pointsOf(edge: ElkExtendedEdge | undefined): Point[] {
  return (edge?.sections ?? []).flatMap(({ startPoint, bendPoints = [], endPoint }) => [
    startPoint,
    ...bendPoints,
    endPoint,
  ]);
}

interface ElkGlobal {
  ElkWorker?: new (url?: string) => Worker;
}

async function start(): Promise<Elk> {
  const program = await unpack("layout");
  const address = URL.createObjectURL(new Blob([program], { type: "text/javascript" }));
  try {
    const worker = new Worker(address);
    return new ELK({ workerFactory: () => worker });
  } catch {
    const script = document.createElement("script");
    script.textContent = program; // its hash is among those that the policy of the page allows
    document.head.append(script);
    const InPage = (globalThis as ElkGlobal).ElkWorker;
    if (!InPage) throw new Error("the layout program does not run here");
    return new ELK({ workerFactory: (url) => new InPage(url) });
  }
}
