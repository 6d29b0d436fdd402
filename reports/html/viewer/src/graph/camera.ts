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
  fit: () => void;
  zoom: (factor: number) => void;
  /** Show this part, without zooming further out than it needs. */
  reveal: (part: Rectangle) => void;
}

const CLOSEST = 3;
const FARTHEST = 0.02;
const READABLE = 1;
const STEP = 60;
/** Milliseconds that the view has to rest before it is told of. */
const REST = 250;
/** The camera on a drawing. It begins where `start` says (see `onRest`), otherwise with all of the drawing, as with any other drawing later. */
export function useCamera(
  svg: RefObject<SVGSVGElement>,
  scene: RefObject<SVGGElement>,
  whole: Rectangle,
  start: string,
  /** Is told the middle of the view and its scale, or "" when it is all of the drawing. */
  onRest: (view: string) => void,
  /** Is told the scale whenever the view changes. */
  onScale: (scale: number) => void,
): Camera {
  const view = useRef<View>({ x: 0, y: 0, scale: 1 });
  const begin = useRef(start);
  const resting = useRef(0);
  const tell = useRef(onRest);
  tell.current = onRest;
  const tellScale = useRef(onScale);
  tellScale.current = onScale;

  const apply = useCallback(() => {
    const { x, y, scale } = view.current;
    scene.current?.setAttribute("transform", `translate(${x} ${y}) scale(${scale})`);
    tellScale.current(scale);
  }, [scene]);

  const moved = useCallback(() => {
    apply();
    clearTimeout(resting.current);
    resting.current = setTimeout(() => {
      const box = svg.current?.getBoundingClientRect();
      if (box) tell.current(written(view.current, box));
    }, REST);
  }, [svg, apply]);
  useEffect(() => () => clearTimeout(resting.current), []);

  const zoomAt = useCallback(
    (factor: number, px: number, py: number) => {
      const { x, y, scale } = view.current;
      const next = Math.min(CLOSEST, Math.max(FARTHEST, scale * factor));
      const ratio = next / scale;
      view.current = { x: px - (px - x) * ratio, y: py - (py - y) * ratio, scale: next };
      moved();
    },
    [moved],
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
      moved();
    },
    [svg, moved],
  );
  const fit = useCallback(() => {
    show(whole, READABLE);
    clearTimeout(resting.current);
    tell.current("");
  }, [show, whole]);

  useEffect(() => {
    const box = svg.current?.getBoundingClientRect();
    const found = box && read(begin.current, box);
    begin.current = "";
    if (!found) return fit();
    view.current = found;
    apply();
  }, [svg, fit, apply]);
  useEffect(() => {
    const element = svg.current;
    return element ? listen(element, view, moved, zoomAt) : undefined;
  }, [svg, moved, zoomAt]);

  return {
    fit,
    zoom: (factor) => {
      const box = svg.current?.getBoundingClientRect();
      if (box) zoomAt(factor, box.width / 2, box.height / 2);
    },
    reveal: (part) => show(grown(part), Math.max(READABLE, view.current.scale)),
  };
}

/** A view as text that does not depend on the size of the frame. */
function written({ x, y, scale }: View, box: DOMRect): string {
  const [middle, height] = [(box.width / 2 - x) / scale, (box.height / 2 - y) / scale];
  return `${Math.round(middle)},${Math.round(height)},${Number(scale.toPrecision(3))}`;
}

function read(text: string, box: DOMRect): View | null {
  const [x, y, scale, ...more] = text.split(",").map(Number);
  if (x === undefined || y === undefined || !scale || more.length || ![x, y, scale].every(Number.isFinite)) return null;
  const kept = Math.min(CLOSEST, Math.max(FARTHEST, scale));
  return { x: box.width / 2 - x * kept, y: box.height / 2 - y * kept, scale: kept };
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
  changed: () => void,
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
      changed();
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
    changed();
  };
  const onPaper = () => {
    const { width, height } = element.getBoundingClientRect();
    element.setAttribute("viewBox", `0 0 ${width} ${height}`);
  };
  const onScreen = () => element.removeAttribute("viewBox");
  addEventListener("beforeprint", onPaper);
  addEventListener("afterprint", onScreen);
  element.addEventListener("pointerdown", down);
  element.addEventListener("pointermove", move);
  element.addEventListener("pointerup", up);
  element.addEventListener("pointercancel", up);
  element.addEventListener("click", click, true);
  element.addEventListener("wheel", wheel, { passive: false });
  element.addEventListener("keydown", key);
  return () => {
    removeEventListener("beforeprint", onPaper);
    removeEventListener("afterprint", onScreen);
    element.removeEventListener("pointerdown", down);
    element.removeEventListener("pointermove", move);
    element.removeEventListener("pointerup", up);
    element.removeEventListener("pointercancel", up);
    element.removeEventListener("click", click, true);
    element.removeEventListener("wheel", wheel);
    element.removeEventListener("keydown", key);
  };
}
