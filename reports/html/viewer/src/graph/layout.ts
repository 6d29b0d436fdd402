/** Where everything of a graph is drawn. */
import type { ElkExtendedEdge, ElkNode, LayoutOptions } from "elkjs/lib/elk-api";
import { arrange, type Point, pointsOf, type Rectangle } from "../elk";
import { textWidth } from "../parts/measure";
import type { Box, Frame, ShownConnector, ShownGraph } from "./build";
import { boxLines, CONNECTOR_HEIGHT, connectorLines } from "./measure";

export interface Drawing {
  width: number;
  height: number;
  at: Map<string, Rectangle>;
  /** The middle of each port. */
  ports: Map<string, Point>;
  lines: Map<string, Point[]>;
}

const PORT = 8;
const LARGE = 300; // links, beyond which time matters more than the last crossing

const ROOT: LayoutOptions = {
  "elk.algorithm": "layered",
  "elk.direction": "RIGHT",
  "elk.edgeRouting": "ORTHOGONAL",
  "elk.hierarchyHandling": "INCLUDE_CHILDREN",
  "elk.layered.nodePlacement.strategy": "BRANDES_KOEPF",
  "elk.layered.nodePlacement.bk.fixedAlignment": "BALANCED",
  "elk.layered.spacing.nodeNodeBetweenLayers": "48",
  "elk.layered.spacing.edgeNodeBetweenLayers": "20",
  "elk.layered.spacing.edgeEdgeBetweenLayers": "9",
  "elk.spacing.nodeNode": "18",
  "elk.spacing.edgeNode": "14",
  "elk.spacing.edgeEdge": "9",
  "elk.spacing.portPort": "12",
  "elk.spacing.componentComponent": "36",
  "elk.separateConnectedComponents": "true",
  "elk.aspectRatio": "1.6",
  "elk.padding": "[top=16,left=16,bottom=16,right=16]",
};

export async function layOut(graph: ShownGraph): Promise<Drawing> {
  const { children, edges } = elkGraph(graph);
  const large = graph.links.length > LARGE;
  const layoutOptions = { ...ROOT, "elk.layered.thoroughness": large ? "1" : "7" };
  return read(await arrange({ id: "root", children, edges }, layoutOptions));
}

function elkGraph(graph: ShownGraph): { children: ElkNode[]; edges: ElkExtendedEdge[] } {
  const children = [...inFrame(graph.top), ...[...graph.connectors.values()].map(connectorNode)];
  const edges = graph.links.map((link) => ({
    id: link.id,
    sources: [link.out ? link.port : `${link.connector}|out`],
    targets: [link.out ? `${link.connector}|in` : link.port],
  }));
  return { children, edges };
}

function inFrame(frame: Frame): ElkNode[] {
  return [
    ...frame.boxes.map(boxNode),
    ...frame.frames.map((inner) => ({
      id: inner.id,
      children: inFrame(inner),
      layoutOptions: { "elk.padding": "[top=34,left=14,bottom=14,right=14]" },
    })),
  ];
}

function boxNode(box: Box): ElkNode {
  const lines = boxLines(box);
  const most = Math.max(box.ports.filter((port) => port.out).length, box.ports.filter((port) => !port.out).length);
  return {
    id: box.id,
    width: Math.max(90, ...lines.map(({ text, size, weight }) => textWidth(text, size, weight) + 32)),
    height: Math.max(24 + 16 * (lines.length - 1) + 8, most * 13 + 14),
    ports: box.ports.map((port) => ({
      id: port.id,
      width: PORT,
      height: PORT,
      layoutOptions: { "elk.port.side": port.out ? "EAST" : "WEST", "elk.port.borderOffset": String(-PORT / 2) },
    })),
    layoutOptions: { "elk.portConstraints": "FIXED_SIDE" },
  };
}

function connectorNode(shown: ShownConnector): ElkNode {
  const lines = connectorLines(shown);
  const side = (name: string, where: string) => ({
    id: `${shown.id}|${name}`,
    width: 0,
    height: 0,
    layoutOptions: { "elk.port.side": where },
  });
  return {
    id: shown.id,
    width: Math.max(36, ...lines.map((text) => textWidth(text, 11.5) + 30)),
    height: CONNECTOR_HEIGHT + 14 * (lines.length - 1),
    ports: [side("in", "WEST"), side("out", "EAST")],
    layoutOptions: { "elk.portConstraints": "FIXED_SIDE", "elk.portAlignment.default": "CENTER" },
  };
}

/** Absolute places from those that elk tells relative to what things lie in. */
function read(root: ElkNode): Drawing {
  const drawing: Drawing = {
    width: root.width ?? 0,
    height: root.height ?? 0,
    at: new Map(),
    ports: new Map(),
    lines: new Map(),
  };
  const origins = new Map<string, Point>([["root", { x: 0, y: 0 }]]);
  const visit = (node: ElkNode, origin: Point) => {
    for (const child of node.children ?? []) {
      const place = { x: origin.x + (child.x ?? 0), y: origin.y + (child.y ?? 0) };
      origins.set(child.id, place);
      drawing.at.set(child.id, { ...place, width: child.width ?? 0, height: child.height ?? 0 });
      for (const port of child.ports ?? []) {
        const [x, y] = [port.x ?? 0, port.y ?? 0];
        drawing.ports.set(port.id, { x: place.x + x + (port.width ?? 0) / 2, y: place.y + y + (port.height ?? 0) / 2 });
      }
      visit(child, place);
    }
  };
  visit(root, { x: 0, y: 0 });
  const edges = (node: ElkNode): ElkExtendedEdge[] => [...(node.edges ?? []), ...(node.children ?? []).flatMap(edges)];
  for (const edge of edges(root)) {
    const { container } = edge as { container?: string };
    const origin = origins.get(container ?? "root") ?? { x: 0, y: 0 };
    drawing.lines.set(
      edge.id,
      pointsOf(edge).map(({ x, y }) => ({ x: x + origin.x, y: y + origin.y })),
    );
  }
  return drawing;
}
