/**
 * Which names are told when a drawing is small. They keep a size that can be read, so there is not room for all: those that matter most come
 * first, the groups, then what has most ports and ends, and what would lie across another is left out until one comes closer.
 */
import type { Rectangle } from "../elk";
import { textWidth } from "../parts/measure";
import type { ShownGraph } from "./build";
import type { Drawing } from "./layout";
import { boxLines, connectorLines } from "./measure";

/** Below this scale names have a size of their own. */
export const LEGIBLE = 0.8;

/** A name: where it is in the drawing, and how wide it is on the screen. */
export interface Label {
  id: string;
  of: "frame" | "box" | "connector";
  text: string;
  x: number;
  y: number;
  width: number;
  /** Whether `x` is its beginning rather than its middle. */
  begins: boolean;
}

const LINE = 15; // of the screen
const FRAME_TITLE = { x: 25, y: 9 };

/** What a filter matches comes before what it does not. */
const first = (a: { matched: boolean }, b: { matched: boolean }) => Number(b.matched) - Number(a.matched);

/** The names of a drawing, those that matter most first. */
export function labelsOf(graph: ShownGraph, drawing: Drawing): Label[] {
  const placed = (id: string, of: Label["of"], text: string, width: number): Label[] => {
    const at = drawing.at.get(id);
    return at ? [{ id, of, text, x: at.x + at.width / 2, y: at.y + at.height / 2, width, begins: false }] : [];
  };
  const frames = [...graph.frames.values()].flatMap(({ id, label }) => {
    const at = drawing.at.get(id);
    const width = textWidth(label, 12, 600);
    const [x, y] = [(at?.x ?? 0) + FRAME_TITLE.x, (at?.y ?? 0) + FRAME_TITLE.y];
    return at ? [{ id, of: "frame" as const, text: label, x, y, width, begins: true }] : [];
  });
  const boxes = [...graph.boxes.values()]
    .sort((a, b) => first(a, b) || Number(b.isGroup) - Number(a.isGroup) || b.ports.length - a.ports.length)
    .flatMap((box) => {
      const text = boxLines(box)[0]?.text ?? "";
      return placed(box.id, "box", text, textWidth(text, 11, 600));
    });
  const ends = (connectors: { sources: unknown[]; sinks: unknown[] }[]) =>
    connectors.reduce((sum, { sources, sinks }) => sum + sources.length + sinks.length, 0);
  const connectors = [...graph.connectors.values()]
    .filter((shown) => connectorLines(shown).length === 1)
    .sort((a, b) => first(a, b) || ends(b.connectors) - ends(a.connectors))
    .flatMap((shown) => {
      const text = connectorLines(shown)[0] ?? "";
      return placed(shown.id, "connector", text, textWidth(text, 10));
    });
  return [...frames, ...boxes, ...connectors];
}

/** The ids of those that have room at a scale. */
export function fitting(labels: readonly Label[], scale: number): ReadonlySet<string> {
  const told = new Set<string>();
  const taken = new Map<string, Rectangle[]>();
  for (const { id, x, y, width, begins } of labels) {
    const place = { x: x * scale - (begins ? 0 : width / 2), y: y * scale - LINE / 2, width, height: LINE };
    const cells = cellsOf(place);
    if (cells.some((cell) => taken.get(cell)?.some((other) => overlap(place, other)))) continue;
    for (const cell of cells) taken.set(cell, [...(taken.get(cell) ?? []), place]);
    told.add(id);
  }
  return told;
}

const CELL = 64;

function cellsOf({ x, y, width, height }: Rectangle): string[] {
  const found: string[] = [];
  for (let column = Math.floor(x / CELL); column <= (x + width) / CELL; column++)
    for (let row = Math.floor(y / CELL); row <= (y + height) / CELL; row++) found.push(`${column} ${row}`);
  return found;
}

const overlap = (a: Rectangle, b: Rectangle): boolean =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
