/** What of a system the graph shows, as the address has it. */
import type { ConnectorKind, System } from "../data";
import { CONNECTOR_KINDS } from "../parts/kinds";

type Grouping = "namespace" | "package" | "none";
const GROUPINGS: readonly Grouping[] = ["namespace", "package", "none"];

export interface GraphOptions {
  kinds: ReadonlySet<ConnectorKind>;
  /** Connectors that only libraries make. */
  implicit: boolean;
  /** Connectors with a sender or a receiver only. */
  oneSided: boolean;
  /** Whether connectors that join the same nodes are drawn as one. */
  bundled: boolean;
  filter: string;
  /** Whether what the filter does not match is left out, rather than shown paler. */
  only: boolean;
  findings: boolean;
  focus: string;
  hops: number;
  grouping: Grouping;
  /** Groups that are not as they are at first: all open, or in large systems all closed. */
  toggled: ReadonlySet<string>;
  closed: boolean;
  selected: string;
  /** The ends of a chain that is lit. */
  from: string;
  to: string;
}

/** Systems with more nodes than this are shown with groups closed at first. */
const MANY_NODES = 24;
const MANY_CONNECTORS = 40;
const SHOWN_AT_FIRST: readonly ConnectorKind[] = ["topic", "service", "action"];

export function readOptions(params: URLSearchParams, system: System): GraphOptions {
  const many = system.nodes.length > MANY_NODES;
  const grouping = GROUPINGS.find((each) => each === params.get("by")) ?? (many ? bestGrouping(system) : "namespace");
  return {
    kinds: new Set(
      listed(params, "kinds", SHOWN_AT_FIRST).filter((kind): kind is ConnectorKind =>
        CONNECTOR_KINDS.includes(kind as ConnectorKind),
      ),
    ),
    implicit: params.has("implicit"),
    oneSided: !params.has("joined"),
    bundled: (params.get("bundle") ?? (system.connectors.length > MANY_CONNECTORS ? "1" : "0")) === "1",
    filter: params.get("filter") ?? "",
    only: params.has("only"),
    findings: params.has("findings"),
    focus: params.get("focus") ?? "",
    hops: Math.min(9, Math.max(1, Number(params.get("hops")) || 1)),
    grouping,
    toggled: new Set(listed(params, "groups", [])),
    closed: many,
    selected: params.get("at") ?? "",
    from: params.get("from") ?? "",
    to: params.get("to") ?? "",
  };
}

function listed(params: URLSearchParams, name: string, otherwise: readonly string[]): string[] {
  const text = params.get(name);
  return text === null ? [...otherwise] : text.split(",").filter(Boolean);
}

/** Fewer groups tell too little. */
const FEW_GROUPS = 4;

/** That which makes fewer things to look at, unless these are too few. */
function bestGrouping(system: System): Grouping {
  const namespaces = new Set(system.nodes.map((node) => namespaceOf(node.name).split("/")[1] || node.name)).size;
  const packages = new Set(system.nodes.map((node) => node.package)).size;
  if (Math.min(namespaces, packages) < FEW_GROUPS) return packages > namespaces ? "package" : "namespace";
  return packages < namespaces ? "package" : "namespace";
}

/** `/a/b` of `/a/b/c`; empty for the outermost. */
export function namespaceOf(name: string): string {
  return name.slice(0, Math.max(0, name.lastIndexOf("/")));
}

export function isOpen(options: GraphOptions, group: string): boolean {
  return options.toggled.has(group) === options.closed;
}

export function toggledGroups(options: GraphOptions, group: string): string {
  const next = new Set(options.toggled);
  if (!next.delete(group)) next.add(group);
  return [...next].join(",");
}

export function toggledKinds(options: GraphOptions, kind: ConnectorKind): string | null {
  const next = CONNECTOR_KINDS.filter((each) => (each === kind) !== options.kinds.has(each));
  return next.join() === SHOWN_AT_FIRST.join() ? null : next.join() || "none";
}
