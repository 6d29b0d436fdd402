/** The drawing of a graph in a frame that can be moved, with what the pointer and keys do on it. */
import type { RefObject } from "preact";
import { useEffect, useMemo, useRef } from "preact/hooks";
import type { ShownGraph } from "./build";
import { type Camera, useCamera } from "./camera";
import { GraphDrawing } from "./drawing";
import { fitting, type Label, LEGIBLE, labelsOf } from "./labels";
import type { Drawing } from "./layout";

interface Props {
  graph: ShownGraph;
  drawing: Drawing;
  filtered: boolean;
  selected: string;
  /** What a chain leads through, lit while nothing else is. */
  chain: ReadonlySet<string>;
  label: string;
  /** Where the view begins and where it comes to rest, as texts. */
  view: string;
  onView: (view: string) => void;
  onSelect: (id: string) => void;
  onOpen: (id: string) => void;
  onGroup: (group: string) => void;
  onHover: (id: string | null, at: { x: number; y: number }) => void;
  onCamera: (camera: Camera) => void;
}

export function GraphCanvas(props: Props) {
  const {
    graph,
    drawing,
    filtered,
    selected,
    chain,
    label,
    view,
    onView,
    onSelect,
    onOpen,
    onGroup,
    onHover,
    onCamera,
  } = props;
  const svg = useRef<SVGSVGElement>(null);
  const scene = useRef<SVGGElement>(null);
  const { width, height } = drawing;
  const whole = useMemo(() => ({ x: 0, y: 0, width, height }), [width, height]);
  const labels = useMemo(() => labelsOf(graph, drawing), [graph, drawing]);
  const names = useNames(svg, labels);
  const camera = useCamera(svg, scene, whole, view, onView, names.scaled);
  useEffect(() => onCamera(camera));
  const rest = () => names.lit(selected ? light(scene.current, selected) : lightAll(scene.current, chain));
  useEffect(rest, [selected, chain, drawing]);

  const act = (target: EventTarget | null, open: boolean) => {
    const element = target instanceof Element ? target.closest<SVGGElement>("[data-id], [data-group]") : null;
    if (element?.dataset.group !== undefined) onGroup(element.dataset.group);
    else if (element?.dataset.id && open) onOpen(element.dataset.id);
    else onSelect(element?.dataset.id ?? "");
  };
  const hover = (event: PointerEvent | FocusEvent) => {
    const element = event.target instanceof Element ? event.target.closest<SVGGElement>("[data-id]") : null;
    const id = element?.dataset.id ?? null;
    if (id) names.lit(light(scene.current, id));
    else rest();
    const box = svg.current?.getBoundingClientRect();
    if (!element || !box) return onHover(null, { x: 0, y: 0 });
    const place = element.getBoundingClientRect();
    return onHover(id, { x: place.left - box.left, y: place.bottom - box.top + 6 });
  };
  return (
    <svg
      ref={svg}
      class={graph.links.length > DENSE ? "graph dense" : "graph"}
      role="application"
      aria-label={label}
      tabindex={0}
      onClick={(event) => act(event.target, false)}
      onDblClick={(event) => act(event.target, true)}
      onKeyDown={(event) => {
        if (event.key === "Enter" || event.key === " ") {
          event.preventDefault();
          act(event.target, event.key === "Enter");
        } else if (event.key === "Escape") onSelect("");
        else if (event.key === "+" || event.key === "=") camera.zoom(1.25);
        else if (event.key === "-") camera.zoom(0.8);
        else if (event.key === "0") camera.fit();
      }}
      onPointerOver={hover}
      onFocusIn={hover}
      onPointerLeave={() => {
        rest();
        onHover(null, { x: 0, y: 0 });
      }}
    >
      <g ref={scene}>
        <GraphDrawing graph={graph} drawing={drawing} labels={labels} filtered={filtered} selected={selected} />
      </g>
    </svg>
  );
}

const DENSE = 300; // links, beyond which lines are paler
const NONE: ReadonlySet<string> = new Set();
const LEVEL = 1.15; // scales closer to each other than by this factor show the same names

interface Names {
  /** The drawing has another scale. */
  scaled: (scale: number) => void;
  /** Only these are lit, or with none all is as ever. */
  lit: (ids: ReadonlySet<string>) => void;
}

/** Shows the names that there is room for, of what is lit if anything is; see labels.ts. */
function useNames(svg: RefObject<SVGSVGElement>, labels: readonly Label[]): Names {
  const shown = useRef({ labels, level: Number.NaN, lit: NONE });
  const show = (level: number, lit: ReadonlySet<string>) => {
    const before = shown.current;
    if (!svg.current || (before.labels === labels && before.level === level && before.lit === lit)) return;
    shown.current = { labels, level, lit };
    svg.current.toggleAttribute("data-far", level < 0);
    if (level >= 0) return;
    const scale = LEGIBLE * LEVEL ** level;
    svg.current.style.setProperty("--px", `${1 / scale}px`);
    const told = fitting(lit.size ? labels.filter(({ id }) => lit.has(id)) : labels, scale);
    for (const name of svg.current.querySelectorAll<SVGTextElement>("[data-name]"))
      name.toggleAttribute("data-told", told.has(name.dataset.name ?? ""));
  };
  return {
    scaled: (scale) => show(Math.floor(Math.log(scale / LEGIBLE) / Math.log(LEVEL)), shown.current.lit),
    lit: (ids) => show(shown.current.level, ids.size ? ids : NONE),
  };
}

/** Light what is connected with a box or connector, and make the rest pale. */
function light(scene: SVGGElement | null, id: string): ReadonlySet<string> {
  const lit = new Set([id]);
  const links = [...(scene?.querySelectorAll<SVGPathElement>(".link") ?? [])];
  const isBox = id.startsWith("node:") || id.startsWith("group:");
  for (const { dataset } of links) if (isBox && dataset.box === id) lit.add(dataset.connector ?? "");
  for (const { dataset } of links) if (lit.has(dataset.connector ?? "")) lit.add(dataset.box ?? "");
  return lightAll(scene, lit, (link) => lit.has(link.dataset.connector ?? ""));
}

/** Light these, and links as they say; all of the drawing is as ever without any. */
function lightAll(
  scene: SVGGElement | null,
  lit: ReadonlySet<string>,
  wanted: (link: SVGPathElement) => boolean = ({ dataset }) =>
    lit.has(dataset.connector ?? "") && lit.has(dataset.box ?? ""),
): ReadonlySet<string> {
  if (!scene) return lit;
  for (const element of scene.querySelectorAll<SVGGElement>("[data-id]")) {
    element.classList.toggle("lit", lit.has(element.dataset.id ?? ""));
  }
  for (const link of scene.querySelectorAll<SVGPathElement>(".link"))
    link.classList.toggle("lit", lit.size > 0 && wanted(link));
  const some = scene.querySelector("[data-id].lit") !== null;
  scene.classList.toggle("some-lit", some);
  return some ? lit : NONE;
}
