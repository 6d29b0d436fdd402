/** From a system to what is drawn: boxes (nodes and groups of nodes), connectors, and the links between their ports. */
import type { Connector, ConnectorKind, End, Finding, Severity, System, SystemNode, SystemPort } from "../data";
import { grouped, worst } from "../model";
import { matches } from "../parts/controls";
import { isOutgoing } from "../parts/kinds";
import { type GraphOptions, isOpen, namespaceOf } from "./options";

export interface BoxPort {
  id: string;
  kind: ConnectorKind;
  out: boolean;
  ports: SystemPort[];
}

export interface Box {
  id: string;
  label: string;
  detail: string;
  /** One node, or all that a closed group has. */
  nodes: SystemNode[];
  isGroup: boolean;
  ports: BoxPort[];
  severity: Severity | null;
  matched: boolean;
}

/** An open group. */
export interface Frame {
  id: string;
  label: string;
  boxes: Box[];
  frames: Frame[];
}

export interface ShownConnector {
  id: string;
  kind: ConnectorKind;
  connectors: Connector[];
  oneSided: boolean;
  matched: boolean;
}

export interface Link {
  id: string;
  kind: ConnectorKind;
  box: string;
  port: string;
  connector: string;
  /** Whether it leads from the box to the connector. */
  out: boolean;
  conditional: boolean;
}

export interface ShownGraph {
  top: Frame;
  boxes: Map<string, Box>;
  frames: Map<string, Frame>;
  connectors: Map<string, ShownConnector>;
  links: Link[];
  hidden: Map<string, number>;
}

type FindingsOf = (node: SystemNode) => Finding[];

export function buildGraph(system: System, options: GraphOptions, findingsOf: FindingsOf): ShownGraph {
  const hidden = new Map<string, number>();
  const connectors = system.connectors.filter((connector) => isWanted(connector, options, hidden));
  const shown = shownNodes(system, connectors, options, findingsOf);
  const { top, boxes, frames, boxOf } = arranged(system, shown, options, findingsOf);
  const graph: ShownGraph = { top, boxes, frames, connectors: new Map(), links: [], hidden };
  const ends = connectors.flatMap((connector) => {
    const sources = connector.sources.filter(([node]) => boxOf.has(node));
    const sinks = connector.sinks.filter(([node]) => boxOf.has(node));
    return sources.length + sinks.length ? pieces({ connector, sources, sinks }, boxOf, boxes, options, hidden) : [];
  });
  const focused = options.focus ? nodesNamed(system, options.focus) : null;
  const isNear = ({ sources, sinks }: Piece) =>
    !focused ||
    new Set([...sources, ...sinks].map(([node]) => boxOf.get(node))).size > 1 ||
    [...sources, ...sinks].some(([node]) => focused.has(node));
  for (const [id, same] of grouped(ends.filter(isNear), (piece) => piece.id))
    connect(graph, system, id, same, boxOf, options);
  return graph;
}

interface Ends {
  connector: Connector;
  sources: End[];
  sinks: End[];
}

interface Piece extends Ends {
  /** Equal for what is drawn as one. */
  id: string;
}

/**
 * What a connector is drawn as: itself, or with others that join the same boxes. Where closed groups are among its ends, it is part of
 * bundles, one for each pair of boxes.
 */
function pieces(
  ends: Ends,
  boxOf: Map<number, string>,
  boxes: Map<string, Box>,
  options: GraphOptions,
  hidden: Map<string, number>,
): Piece[] {
  const { connector } = ends;
  const byBox = (list: End[]) => [...grouped(list, ([node]) => boxOf.get(node) ?? "")];
  const [from, to] = [byBox(ends.sources), byBox(ends.sinks)];
  const hasGroup = [...from, ...to].some(([box]) => boxes.get(box)?.isGroup);
  if (!hasGroup && !options.bundled) return [{ ...ends, id: `connector:${connector.kind}:${connector.name}` }];
  if (!hasGroup) {
    const side = (list: [string, End[]][]) =>
      list
        .map(([box]) => box)
        .sort()
        .join();
    return [{ ...ends, id: `bundle:${connector.kind}:${side(from)}>${side(to)}${isOneSided(connector) ? "" : "!"}` }];
  }
  const bundle = (source: string, sink: string, sources: End[], sinks: End[]): Piece => ({
    connector,
    sources,
    sinks,
    id: `bundle:${connector.kind}:${source}>${sink}`,
  });
  if (!from.length) return to.map(([box, sinks]) => bundle("", box, [], sinks));
  if (!to.length) return from.map(([box, sources]) => bundle(box, "", sources, []));
  const found = from.flatMap(([source, sources]) =>
    to.flatMap(([sink, sinks]) =>
      source === sink && boxes.get(source)?.isGroup ? [] : [bundle(source, sink, sources, sinks)],
    ),
  );
  if (!found.length) increment(hidden, "inside one group");
  return found;
}

const isOneSided = ({ sources, sinks }: Connector): boolean => !sources.length || !sinks.length;

function isWanted(connector: Connector, options: GraphOptions, hidden: Map<string, number>): boolean {
  const reason = !options.kinds.has(connector.kind)
    ? `of kind ${connector.kind}`
    : connector.implicit && !options.implicit && connector.kind !== "tf"
      ? "made by libraries"
      : isOneSided(connector) && !options.oneSided
        ? "with one side only"
        : "";
  if (reason) increment(hidden, reason);
  return !reason;
}

const matchesNode = (filter: string, node: SystemNode) => matches(filter, node.name, node.type, node.package);
const matchesConnector = (filter: string, connector: Connector) => matches(filter, connector.name, ...connector.types);

function nodesNamed(system: System, name: string): Set<number> {
  return new Set(system.nodes.flatMap((node, at) => (node.name === name ? [at] : [])));
}

/** The numbers of the nodes that are shown. */
function shownNodes(
  system: System,
  connectors: Connector[],
  options: GraphOptions,
  findingsOf: FindingsOf,
): Set<number> {
  let shown = new Set(system.nodes.keys());
  if (options.findings) shown = new Set([...shown].filter((at) => findingsOf(system.nodes[at] as SystemNode).length));
  if (options.only && options.filter) {
    const found = new Set([...shown].filter((at) => matchesNode(options.filter, system.nodes[at] as SystemNode)));
    for (const connector of connectors) {
      if (matchesConnector(options.filter, connector))
        for (const [node] of [...connector.sources, ...connector.sinks]) found.add(node);
    }
    shown = new Set([...shown].filter((at) => found.has(at)));
  }
  if (options.focus) {
    let near = nodesNamed(system, options.focus);
    for (let hop = 0; hop < options.hops; hop++) {
      const next = new Set(near);
      for (const { sources, sinks } of connectors) {
        const ends = [...sources, ...sinks].map(([node]) => node);
        if (ends.some((node) => near.has(node))) for (const node of ends) next.add(node);
      }
      near = next;
    }
    shown = new Set([...shown].filter((at) => near.has(at)));
  }
  return shown;
}

/** Boxes in frames, and the box of each node that is shown. */
function arranged(system: System, shown: ReadonlySet<number>, options: GraphOptions, findingsOf: FindingsOf) {
  const top: Frame = { id: "", label: "", boxes: [], frames: [] };
  const frames = new Map<string, Frame>();
  const boxes = new Map<string, Box>();
  const boxOf = new Map<number, string>();
  const sizes = groupSizes(system, shown, options);
  for (const at of shown) {
    const node = system.nodes[at] as SystemNode;
    const groups = groupsOf(node, options).filter((group) => (sizes.get(group) ?? 0) > 1);
    const closed = groups.findIndex((group) => !isOpen(options, group));
    const frame = groups.slice(0, closed < 0 ? groups.length : closed).reduce((outer, group) => {
      const inner = frames.get(group) ?? { id: `frame:${group}`, label: group, boxes: [], frames: [] };
      if (!frames.has(group)) outer.frames.push(inner);
      frames.set(group, inner);
      return inner;
    }, top);
    const id = closed < 0 ? `node:${at}` : `group:${groups[closed]}`;
    const box = boxes.get(id) ?? newBox(id, node, closed < 0 ? null : (groups[closed] ?? null), frame.label, options);
    if (!boxes.has(id)) frame.boxes.push(box);
    boxes.set(id, box);
    box.nodes.push(node);
    boxOf.set(at, id);
  }
  for (const box of boxes.values()) {
    box.severity = worst(box.nodes.flatMap(findingsOf));
    box.matched = !options.filter || box.nodes.some((node) => matchesNode(options.filter, node));
    if (box.isGroup) box.detail = `${box.nodes.length} nodes`;
  }
  return { top, boxes, frames, boxOf };
}

function newBox(id: string, node: SystemNode, group: string | null, frame: string, options: GraphOptions): Box {
  const inside = options.grouping === "namespace" && frame && node.name.startsWith(`${frame}/`);
  return {
    id,
    label: group ?? (inside ? node.name.slice(frame.length + 1) : node.name),
    detail: group ? "" : `${node.package}/${node.type}`,
    nodes: [],
    isGroup: group !== null,
    ports: [],
    severity: null,
    matched: true,
  };
}

function increment(counts: Map<string, number>, key: string) {
  counts.set(key, (counts.get(key) ?? 0) + 1);
}

function groupsOf(node: SystemNode, options: GraphOptions): string[] {
  if (options.grouping === "none") return [];
  if (options.grouping === "package") return [node.package];
  const parts = namespaceOf(node.name).split("/").slice(1);
  return parts.map((_, at) => `/${parts.slice(0, at + 1).join("/")}`);
}

function groupSizes(system: System, shown: ReadonlySet<number>, options: GraphOptions): Map<string, number> {
  const sizes = new Map<string, number>();
  for (const at of shown) {
    for (const group of groupsOf(system.nodes[at] as SystemNode, options)) increment(sizes, group);
  }
  return sizes;
}

function connect(
  graph: ShownGraph,
  system: System,
  id: string,
  same: Piece[],
  boxOf: Map<number, string>,
  options: GraphOptions,
) {
  const [first] = same;
  if (!first) return;
  const connectors = [...new Set(same.map(({ connector }) => connector))];
  const { kind } = first.connector;
  graph.connectors.set(id, {
    id,
    kind,
    connectors,
    oneSided: connectors.every(isOneSided),
    matched: !options.filter || connectors.some((connector) => matchesConnector(options.filter, connector)),
  });
  const links = new Map<string, { link: Link; ports: SystemPort[] }>();
  for (const { sources, sinks } of same) {
    for (const [ends, out] of [
      [sources, true],
      [sinks, false],
    ] as const) {
      for (const [at, number] of ends) {
        const node = system.nodes[at] as SystemNode;
        const port = node.ports[number] as SystemPort;
        const box = boxOf.get(at) as string;
        const own = connectors.length > 1 || graph.boxes.get(box)?.isGroup ? "" : port.id;
        const key = `${box} ${own} ${out}`;
        const conditional = Boolean(port.conditional || node.conditions.length);
        const known = links.get(key);
        if (known) {
          known.ports.push(port);
          known.link.conditional &&= conditional;
        } else {
          const portId = `${box}|${own || id}|${out ? "out" : "in"}`;
          links.set(key, {
            link: { id: `${portId}~${id}`, kind, box, port: portId, connector: id, out, conditional },
            ports: [port],
          });
        }
      }
    }
  }
  for (const { link, ports } of links.values()) {
    graph.links.push(link);
    const box = graph.boxes.get(link.box);
    if (box && !box.ports.some((port) => port.id === link.port)) {
      box.ports.push({ id: link.port, kind: link.kind, out: ports[0] ? isOutgoing(ports[0].kind) : link.out, ports });
    }
  }
}
