/** The report with what its pages look up often. */
import type {
  Component,
  Finding,
  Periodic,
  Place,
  Port,
  Rate,
  ReportDocument,
  Severity,
  System,
  SystemNode,
} from "./data";

export interface Instance {
  system: System;
  node: SystemNode;
}

export interface Report {
  document: ReportDocument;
  component: Map<string, Component>;
  /** Where each component is started, by its name. */
  instances: Map<string, Instance[]>;
  /** Findings that have evidence in a source of the component, or at a launch line that starts it. */
  findingsOf: (component: Component) => Finding[];
  findingsOfNode: (system: System, node: SystemNode) => Finding[];
}

export const SEVERITIES: readonly Severity[] = ["error", "warning", "note"];

export function indexed(document: ReportDocument): Report {
  const instances = new Map<string, Instance[]>();
  for (const system of document.systems) {
    for (const node of system.nodes) {
      if (node.component) listIn(instances, node.component).push({ system, node });
    }
  }
  const byPlace = new Map<Place, Finding[]>();
  for (const finding of document.findings.shown) {
    for (const place of new Set(finding.evidence.map((step) => step.at))) listIn(byPlace, place).push(finding);
  }
  const at = (places: Iterable<Place | null | undefined>) =>
    [...new Set([...places].flatMap((place) => (place && byPlace.get(place)) || []))].sort(bySeverity);
  return {
    document,
    component: new Map(document.components.map((component) => [component.name, component])),
    instances,
    findingsOf: (component) => at(placesOf(component)),
    findingsOfNode: (system, node) =>
      at([...node.lines.slice(-1), ...node.ports.map((port) => port.at)]).filter((found) =>
        found.systems.includes(system.name),
      ),
  };
}

function placesOf(component: Component): Place[] {
  return [...component.ports, ...component.params, ...component.periodic, ...component.transitions].map(
    (each) => each.at,
  );
}

export function bySeverity(a: Finding, b: Finding): number {
  return SEVERITIES.indexOf(a.severity) - SEVERITIES.indexOf(b.severity);
}

export function worst(findings: readonly Finding[]): Severity | null {
  return SEVERITIES.find((severity) => findings.some((finding) => finding.severity === severity)) ?? null;
}

function listIn<Key, Value>(map: Map<Key, Value[]>, key: Key): Value[] {
  const found = map.get(key) ?? [];
  map.set(key, found);
  return found;
}

export function portsById(component: Component): Map<string, Port> {
  return new Map(component.ports.map((port) => [port.id, port]));
}

/** A port as the keys of proofs name it; see models/derivations.py. */
export function portKey(port: Port | undefined): string {
  return port ? `${port.kind} ${port.name} ${port.at}` : "";
}

export function counted(number: number, noun: string): string {
  if (number === 1) return `1 ${noun}`;
  return `${number.toLocaleString("en")} ${noun.endsWith("y") ? `${noun.slice(0, -1)}ies` : `${noun}s`}`;
}

/** How many of all there are are shown. */
export function countedOf(shown: number, all: number, noun: string): string {
  return shown === all ? counted(all, noun) : `${shown} of ${counted(all, noun)}`;
}

/** Numbers as people write them: at most four digits that count. */
export function amount(value: number): string {
  return String(Number(value.toPrecision(4)));
}

/** The ports that a timed loop or timer sends through. */
export const sentIn = ({ publishes, calls = [] }: Periodic): string[] => [...publishes, ...calls];

export function frequency(hz: number | null): string {
  return hz === null ? "rate not known" : `${amount(hz)} Hz`;
}

/** Messages a second. */
export function rateText(rate: Rate): string {
  if (rate.high === null) return rate.low ? `${amount(rate.low)} or more` : "not known";
  return rate.low === rate.high ? amount(rate.low) : `${amount(rate.low)} to ${amount(rate.high)}`;
}

export function grouped<Key, Value>(values: Iterable<Value>, keyOf: (value: Value) => Key): Map<Key, Value[]> {
  const found = new Map<Key, Value[]>();
  for (const value of values) listIn(found, keyOf(value)).push(value);
  return found;
}
