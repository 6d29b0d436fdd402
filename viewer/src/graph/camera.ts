/** Panning and zooming of a drawing: by pointer, wheel, two fingers and keys. */
import type { RefObject } from "preact";
import { useCallback, useEffect, useRef } from "preact/hooks";
import type { Rectangle } from "../elk";

interface View {
  x: number;
  y: number;
  scale: number;
}

export interface Camera {
  fit: (part?: Rectangle) => void;
  zoom: (factor: number) => void;
  /** Show this part, without zooming further out than it needs. */
  reveal: (part: Rectangle) => void;
}

const CLOSEST = 3;
const FARTHEST = 0.02;
const READABLE = 1;
const STEP = 60;
/** Below this scale texts cannot be read: names of nodes grow, others are left out. */
const LEGIBLE = 0.5;

export function useCamera(svg: RefObject<SVGSVGElement>, scene: RefObject<SVGGElement>, whole: Rectangle): Camera {
  const view = useRef<View>({ x: 0, y: 0, scale: 1 });

  const apply = useCallback(() => {
    const { x, y, scale } = view.current;
    scene.current?.setAttribute("transform", `translate(${x} ${y}) scale(${scale})`);
    svg.current?.classList.toggle("far", scale < LEGIBLE);
    svg.current?.style.setProperty("--far", String(LEGIBLE / scale));
  }, [svg, scene]);

  const zoomAt = useCallback(
    (factor: number, px: number, py: number) => {
      const { x, y, scale } = view.current;
      const next = Math.min(CLOSEST, Math.max(FARTHEST, scale * factor));
      const ratio = next / scale;
      view.current = { x: px - (px - x) * ratio, y: py - (py - y) * ratio, scale: next };
      apply();
    },
    [apply],
  );

  const show = useCallback(
    (part: Rectangle, most: number) => {
      const box = svg.current?.getBoundingClientRect();
      if (!box || !part.width || !part.height) return;
      const scale = Math.max(FARTHEST, Math.min(most, (box.width - 48) / part.width, (box.height - 48) / part.height));
      view.current = {
        x: (box.width - part.width * scale) / 2 - part.x * scale,
        y: (box.height - part.height * scale) / 2 - part.y * scale,
        scale,
      };
      apply();
    },
    [svg, apply],
  );

  useEffect(() => show(whole, READABLE), [show, whole]);
  useEffect(() => {
    const element = svg.current;
    return element ? listen(element, view, apply, zoomAt) : undefined;
  }, [svg, apply, zoomAt]);

  return {
    fit: (part = whole) => show(part, READABLE),
    zoom: (factor) => {
      const box = svg.current?.getBoundingClientRect();
      if (box) zoomAt(factor, box.width / 2, box.height / 2);
    },
    reveal: (part) => show(grown(part), Math.max(READABLE, view.current.scale)),
  };
}

const grown = ({ x, y, width, height }: Rectangle): Rectangle => ({
  x: x - 200,
  y: y - 140,
  width: width + 400,
  height: height + 280,
});

function listen(
  element: SVGSVGElement,
  view: { current: View },
  apply: () => void,
  zoomAt: (factor: number, x: number, y: number) => void,
): () => void {
  const pointers = new Map<number, PointerEvent>();
  let moved = false;
  const offset = (event: { clientX: number; clientY: number }) => {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top] as const;
  };
  const down = (event: PointerEvent) => {
    if (event.button === 0) pointers.set(event.pointerId, event);
    moved = false;
  };
  const move = (event: PointerEvent) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const other = [...pointers.values()].find(({ pointerId }) => pointerId !== event.pointerId);
    if (other) {
      const distance = (one: PointerEvent) => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
      zoomAt(distance(event) / Math.max(1, distance(before)), ...offset(other));
    } else {
      const [dx, dy] = [event.clientX - before.clientX, event.clientY - before.clientY];
      if (!moved && Math.hypot(dx, dy) < 4) return;
      if (!moved) element.setPointerCapture(event.pointerId);
      view.current.x += dx;
      view.current.y += dy;
      apply();
    }
    moved = true;
    pointers.set(event.pointerId, event);
  };
  const up = (event: PointerEvent) => pointers.delete(event.pointerId);
  const click = (event: MouseEvent) => {
    if (moved) event.stopPropagation(); // the end of a drag is no click
    moved = false;
  };
  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    zoomAt(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0018)), ...offset(event));
  };
  const key = (event: KeyboardEvent) => {
    const steps: Record<string, [number, number]> = {
      ArrowLeft: [STEP, 0],
      ArrowRight: [-STEP, 0],
      ArrowUp: [0, STEP],
      ArrowDown: [0, -STEP],
    };
    const step = steps[event.key];
    if (!step || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    view.current.x += step[0];
    view.current.y += step[1];
    apply();
  };
  element.addEventListener("pointerdown", down);
  element.addEventListener("pointermove", move);
  element.addEventListener("pointerup", up);
  element.addEventListener("pointercancel", up);
  element.addEventListener("click", click, true);
  element.addEventListener("wheel", wheel, { passive: false });
  element.addEventListener("keydown", key);
  return () => {
    element.removeEventListener("pointerdown", down);
    element.removeEventListener("pointermove", move);
    element.removeEventListener("pointerup", up);
    element.removeEventListener("pointercancel", up);
    element.removeEventListener("click", click, true);
    element.removeEventListener("wheel", wheel);
    element.removeEventListener("keydown", key);
  };
}
