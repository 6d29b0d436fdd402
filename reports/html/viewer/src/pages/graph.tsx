/** The component-connector graph of a system. */
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { useReport } from "../context";
import type { System } from "../data";
import { buildGraph, type ShownGraph } from "../graph/build";
import type { Camera } from "../graph/camera";
import { GraphCanvas } from "../graph/canvas";
import { findChain } from "../graph/chains";
import { type Drawing, layOut } from "../graph/layout";
import { type GraphOptions, readOptions, toggledGroups } from "../graph/options";
import { Panel } from "../graph/panel";
import { Toolbar } from "../graph/toolbar";
import { Tooltip } from "../graph/tooltip";
import { counted } from "../model";
import { NoSystem, useSystem } from "../parts/system";
import { componentHref, type Route, setParams } from "../route";

export function GraphPage({ route }: { route: Route }) {
  const system = useSystem(route);
  return system ? <SystemGraph system={system} route={route} /> : <NoSystem title="Graph" />;
}

interface Laid {
  graph: ShownGraph;
  drawing: Drawing;
}

function SystemGraph({ system, route }: { system: System; route: Route }) {
  const report = useReport();
  const options = readOptions(route.params, system);
  const graph = useMemo(
    () => buildGraph(system, options, (node) => report.findingsOfNode(system, node)),
    [report, system, structureOf(options)],
  );
  const [laid, failure] = useLayout(graph);
  const chain = useMemo(() => chainIds(system, options, graph), [system, graph, options.from, options.to]);
  const camera = useRef<Camera | null>(null);
  const [hovered, setHovered] = useState<{ id: string; x: number; y: number } | null>(null);
  useReveal(options, laid, camera);
  const select = (id: string) => setParams({ at: id });
  const toggle = (group: string) => setParams({ groups: toggledGroups(options, group), at: null });
  const open = (id: string) => {
    const box = laid?.graph.boxes.get(id);
    const component = box?.nodes[0]?.component;
    if (box?.isGroup) toggle(box.label);
    else if (component && report.component.has(component)) location.hash = componentHref(component);
    else select(id);
  };
  return (
    <div class="graph-page">
      <h1 class="unseen">Graph of {system.name}</h1>
      <Toolbar system={system} options={options} camera={camera} />
      <div class="stage" aria-busy={laid?.graph !== graph}>
        {laid && (
          <GraphCanvas
            graph={laid.graph}
            drawing={laid.drawing}
            filtered={options.filter !== ""}
            selected={options.selected}
            chain={chain}
            label={`Graph of ${counted(graph.boxes.size, "node")} and ${counted(graph.connectors.size, "connector")}`}
            view={route.params.get("view") ?? ""}
            onView={(view) => setParams({ view })}
            onSelect={select}
            onOpen={open}
            onGroup={toggle}
            onHover={(id, at) => setHovered(id ? { id, ...at } : null)}
            onCamera={(now) => {
              camera.current = now;
            }}
          />
        )}
        {laid && hovered && hovered.id !== options.selected && (
          <Tooltip id={hovered.id} x={hovered.x} y={hovered.y} graph={laid.graph} system={system} />
        )}
        {laid && (
          <Panel id={options.selected} graph={laid.graph} system={system} onClose={() => select("")} onGroup={toggle} />
        )}
      </div>
      <Status graph={graph} busy={laid?.graph !== graph} failure={failure} />
    </div>
  );
}

/** What of the options decides on what is drawn, as a text that can be compared. */
function structureOf(options: GraphOptions): string {
  const { selected: _, from: _from, to: _to, kinds, toggled, ...rest } = options;
  return JSON.stringify([[...kinds], [...toggled], rest]);
}

/** The boxes and connectors that the chain leads through which the address names, and the pairs of both that it joins. */
function chainIds(system: System, options: GraphOptions, graph: ShownGraph): ReadonlySet<string> {
  const found = new Set<string>();
  if (!options.from || !options.to) return found;
  for (const [from, to] of findChain(system, options.from, options.to)?.steps ?? []) {
    for (const [at, port] of [from, to]) {
      const node = system.nodes[at];
      for (const box of graph.boxes.values()) if (node && box.nodes.includes(node)) found.add(box.id);
      const name = node?.ports[port]?.name;
      for (const shown of graph.connectors.values())
        if (shown.connectors.some((each) => each.name === name)) found.add(shown.id);
    }
  }
  return found;
}

/** The layout of a graph; until it is there, that of the one before. */
function useLayout(graph: ShownGraph): [Laid | null, string] {
  const [laid, setLaid] = useState<Laid | null>(null);
  const [failure, setFailure] = useState("");
  useEffect(() => {
    let wanted = true;
    layOut(graph).then(
      (drawing) => {
        if (!wanted) return;
        setLaid({ graph, drawing });
        setFailure("");
      },
      (error: unknown) => wanted && setFailure(error instanceof Error ? error.message : String(error)),
    );
    return () => {
      wanted = false;
    };
  }, [graph]);
  return [laid, failure];
}

/** Move to the first thing that a new filter matches. */
function useReveal(options: GraphOptions, laid: Laid | null, camera: { current: Camera | null }) {
  useEffect(() => {
    if (!laid || !options.filter || options.only) return;
    const found = [...laid.graph.boxes.values(), ...laid.graph.connectors.values()].filter(({ matched }) => matched);
    const places = found.flatMap(({ id }) => laid.drawing.at.get(id) ?? []);
    const [first] = places;
    if (first && places.length < 4) camera.current?.reveal(first);
  }, [options.filter, options.only, laid, camera]);
}

function Status({ graph, busy, failure }: { graph: ShownGraph; busy: boolean; failure: string }) {
  const hidden = [...graph.hidden].map(([reason, number]) => `${number} ${reason}`).join(", ");
  const shown = `${counted(graph.boxes.size, "node")}, ${counted(graph.connectors.size, "connector")}, ${counted(graph.links.length, "link")}`;
  const text = failure
    ? `Cannot be laid out: ${failure}`
    : busy
      ? "Laying out …"
      : `${shown}${hidden ? `; not shown: ${hidden}` : ""}`;
  return (
    <p class="status" aria-live="polite">
      {text}
    </p>
  );
}
