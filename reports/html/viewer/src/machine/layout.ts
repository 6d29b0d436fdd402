/** Where the states and transitions of a machine are drawn. */
import type { ElkNode, LayoutOptions } from "elkjs/lib/elk-api";
import type { Effect, Region } from "../data";
import { arrange, type Point, pointsOf, type Rectangle } from "../elk";
import { textWidth } from "../parts/measure";
import { shortened } from "../parts/text";

export const LINE = 15;
export const TITLE = 30;
const WIDEST = 46; // characters of a line
const MOST_LINES = 5;
const MOST_EFFECTS = 6;

type LineKind = "on" | "if" | "sends";

export interface TextLine {
  kind: LineKind;
  text: string;
}

export interface StateShape {
  id: string;
  title: string;
  kind: "state" | "any" | "unreachable";
  inner: TextLine[][];
  inside: Effect[];
  at: Rectangle;
}

export interface TransitionShape {
  id: string;
  effects: Effect[];
  texts: TextLine[][];
  points: Point[];
  label: Rectangle;
}

export interface MachineDrawing {
  width: number;
  height: number;
  states: StateShape[];
  transitions: TransitionShape[];
  starts: Point[][];
}

const OPTIONS: LayoutOptions = {
  "elk.algorithm": "layered",
  "elk.direction": "DOWN",
  "elk.layered.cycleBreaking.strategy": "DEPTH_FIRST",
  "elk.edgeRouting": "ORTHOGONAL",
  "elk.layered.nodePlacement.strategy": "BRANDES_KOEPF",
  "elk.layered.nodePlacement.bk.fixedAlignment": "BALANCED",
  "elk.layered.spacing.nodeNodeBetweenLayers": "30",
  "elk.layered.spacing.edgeNodeBetweenLayers": "14",
  "elk.spacing.nodeNode": "28",
  "elk.spacing.edgeNode": "18",
  "elk.spacing.edgeEdge": "12",
  "elk.spacing.edgeLabel": "4",
  "elk.edgeLabels.inline": "true",
  "elk.padding": "[top=12,left=12,bottom=12,right=12]",
};

/** The lines of what is told of an effect: its trigger, `[guard]`, and what is sent. */
function effectLines(effect: Effect): TextLine[] {
  return [
    ...wrapped(effect.on, "on"),
    ...(effect.if ? wrapped(`[${effect.if}]`, "if") : []),
    ...(effect.sends ? wrapped(`→ ${effect.sends}`, "sends") : []),
  ];
}

function wrapped(text: string, kind: LineKind): TextLine[] {
  const lines: string[] = [""];
  for (const word of text.split(/(?<=[\s,])/)) {
    const last = lines[lines.length - 1] ?? "";
    if (last && (last + word).trimEnd().length > WIDEST) lines.push(word);
    else lines[lines.length - 1] = last + word;
  }
  const shown = lines.slice(0, MOST_LINES).map((line) => shortened(line.trim(), WIDEST));
  if (lines.length > MOST_LINES) shown[MOST_LINES - 1] += " …";
  return shown.map((line) => ({ kind, text: line }));
}

function texts(effects: readonly Effect[]): TextLine[][] {
  const shown = effects.slice(0, MOST_EFFECTS).map(effectLines);
  const more = effects.length - shown.length;
  return more > 0 ? [...shown, [{ kind: "on", text: `and ${more} more, see the table` }]] : shown;
}

const widthOf = (lines: TextLine[][]) =>
  Math.max(0, ...lines.flat().map(({ kind, text }) => textWidth(text, 12, kind === "on" ? 600 : 400)));
const heightOf = (lines: TextLine[][]) => lines.reduce((sum, each) => sum + each.length * LINE + 4, 0);

export async function layOutMachine(region: Region): Promise<MachineDrawing> {
  const { states, transitions } = shapes(region);
  const starts = region.initial.map((state, at) => ({ id: `start${at}`, target: `s${state}` }));
  const root = await arrange(
    {
      id: "root",
      children: [
        ...starts.map(({ id }) => ({
          id,
          width: 12,
          height: 12,
          layoutOptions: { "elk.layered.layering.layerConstraint": "FIRST_SEPARATE" },
        })),
        ...states.map(({ id, at: { width, height } }) => ({ id, width, height })),
      ],
      edges: [
        ...starts.map(({ id, target }) => ({ id: `${id}e`, sources: [id], targets: [target] })),
        ...transitions.map(({ id, texts: lines, source, target }) => ({
          id,
          sources: [source],
          targets: [target],
          labels: [{ id: `${id}l`, text: " ", width: widthOf(lines) + 12, height: heightOf(lines) }],
        })),
      ],
    },
    OPTIONS,
  );
  return read(root, states, transitions, starts);
}

type Unplaced = Pick<TransitionShape, "id" | "effects" | "texts"> & { source: string; target: string };

function shapes(region: Region): { states: StateShape[]; transitions: Unplaced[] } {
  const idOf = (state: number) => (state < 0 ? "any" : `s${state}`);
  const inside = new Map(
    region.edges.filter(({ source, target }) => source === target).map(({ source, effects }) => [source, effects]),
  );
  const state = (id: string, title: string, kind: StateShape["kind"], effects: Effect[]): StateShape => {
    const inner = texts(effects);
    const width = Math.max(70, textWidth(shortened(title, 60), 13, 600) + 32, widthOf(inner) + 24);
    return {
      id,
      title,
      kind,
      inner,
      inside: effects,
      at: { x: 0, y: 0, width, height: TITLE + (inner.length ? heightOf(inner) + 8 : 0) },
    };
  };
  const states = region.states.map((title, at) => state(idOf(at), title, "state", inside.get(at) ?? []));
  if (region.edges.some(({ source }) => source < 0)) states.push(state("any", "any state", "any", []));
  states.push(...region.unreachable.map((title, at) => state(`u${at}`, title, "unreachable", [])));
  const transitions = region.edges
    .filter(({ source, target }) => source !== target)
    .map(({ source, target, effects }, at) => ({
      id: `t${at}`,
      effects,
      texts: texts(effects),
      source: idOf(source),
      target: idOf(target),
    }));
  return { states, transitions };
}

function read(root: ElkNode, states: StateShape[], transitions: Unplaced[], starts: { id: string }[]): MachineDrawing {
  const places = new Map(
    (root.children ?? []).map(({ id, x = 0, y = 0, width = 0, height = 0 }) => [id, { x, y, width, height }]),
  );
  const edges = new Map((root.edges ?? []).map((edge) => [edge.id, edge]));
  return {
    width: root.width ?? 0,
    height: root.height ?? 0,
    states: states.map((shape) => ({ ...shape, at: places.get(shape.id) ?? shape.at })),
    transitions: transitions.map(({ id, effects, texts }) => {
      const edge = edges.get(id);
      const { x = 0, y = 0, width = 0, height = 0 } = edge?.labels?.[0] ?? {};
      return { id, effects, texts, points: pointsOf(edge), label: { x, y, width, height } };
    }),
    starts: starts.map(({ id }) => pointsOf(edges.get(`${id}e`))),
  };
}
