/** Lines of drawings. */
import type { Point } from "../elk";

/** A line of horizontal and vertical pieces with round corners. */
export function rounded(points: readonly Point[], radius = 6): string {
  const [first] = points;
  if (!first) return "";
  let path = `M${first.x} ${first.y}`;
  for (let at = 1; at < points.length - 1; at++) {
    const [before, corner, after] = [points[at - 1] as Point, points[at] as Point, points[at + 1] as Point];
    const start = toward(corner, before, radius);
    const end = toward(corner, after, radius);
    path += `L${start.x} ${start.y}Q${corner.x} ${corner.y} ${end.x} ${end.y}`;
  }
  const last = points[points.length - 1] as Point;
  return `${path}L${last.x} ${last.y}`;
}

function toward(from: Point, to: Point, most: number): Point {
  const length = Math.hypot(to.x - from.x, to.y - from.y) || 1;
  const part = Math.min(most, length / 2) / length;
  return { x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part };
}
