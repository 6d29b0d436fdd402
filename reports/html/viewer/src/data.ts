/** The document of a report, as reports/html/document.py makes it. A place is `path:line`. */

export type Place = string;
export type Severity = "error" | "warning" | "note";
export type ConnectorKind = "topic" | "service" | "action" | "tf";

export interface Port {
  id: string;
  kind: string;
  name: string;
  from_param: string | null;
  type: string | null;
  queue: number | null;
  latched: boolean;
  callback: string | null;
  via: string;
  at: Place;
  conditional: string | null;
  implicit?: boolean;
  unknown?: string;
  in_namespace?: string;
  /** Of ROS 2: policies of the quality of service that are told, and the profile it begins as. */
  qos?: Record<string, string>;
}

export interface Parameter {
  name: string;
  op?: string;
  type: string | null;
  default: string | number | boolean | null;
  at: Place;
}

export interface Periodic {
  mechanism: string;
  hz: number | null;
  hz_from_param: string | null;
  publishes: string[];
  calls?: string[];
  at: Place;
  conditional: string | null;
}

export interface Reactive {
  input: string;
  output: string;
  at: Place[];
  must: boolean;
  when: string | null;
}

export interface OneShot {
  after: number | null;
  after_from_param: string | null;
  output: string;
  sent_at: Place[];
  must: boolean;
  at: Place;
  when: string | null;
}

export interface Deferred {
  input: string;
  output: string;
  variable: string;
}

export interface Variable {
  name: string;
  type: string;
  initial: string | null;
  from_param?: string;
  domain: string[] | null;
  at: Place;
}

export interface Assignment {
  variable: string;
  field?: string;
  trigger: string[];
  guard: string | null;
  value: string | null;
  at: Place;
}

/** What triggers lead to under one guard. */
export interface Effect {
  on: string;
  if: string;
  sends: string;
  at: Place[];
}

export interface Region {
  title: string;
  states: string[];
  initial: number[];
  unreachable: string[];
  never: string[];
  /** For a diagram: numbers of states, -1 for any; those that stay in a state lead back to it. */
  edges: { source: number; target: number; effects: Effect[] }[];
  /** The same for a table. */
  arcs: (Effect & { from: string; to: string })[];
}

export interface Machine {
  regions: Region[];
  always: string[];
  left_out: string[];
  dead: { list: string; at: Place[] }[];
  messages: string[];
}

export interface Component {
  name: string;
  component: string;
  package: string;
  kind: string;
  middleware: string | null;
  node_name: string | null;
  /** Of a node that is one of several of a program: the program. */
  executable?: string;
  /** What launch files start it as, where that need not be its name. */
  executables?: string[];
  /** Of a class that programs load: its name, and what they want it as. */
  plugin?: { name: string; base: string | null };
  sources: string[];
  ports: Port[];
  params: Parameter[];
  reconfigurable: Parameter[];
  periodic: Periodic[];
  reactive: Reactive[];
  one_shot: OneShot[];
  reactive_deferred: Deferred[];
  state_variables: Variable[];
  configuration: Variable[];
  transitions: Assignment[];
  machine: Machine;
}

export interface SystemPort {
  id: string;
  kind: string;
  name: string;
  written: string;
  type: string | null;
  at?: Place;
  implicit?: boolean;
  conditional?: string;
}

export interface SystemNode {
  id: string;
  name: string;
  package: string;
  type: string;
  origin: "source" | "library" | "unknown";
  component: string | null;
  lines: Place[];
  conditions: string[];
  open: boolean;
  ports: SystemPort[];
  rates: [Place, number][];
}

/** Numbers of a node and of one of its ports. */
export type End = [number, number];

export interface Connector {
  kind: ConnectorKind;
  name: string;
  types: string[];
  sources: End[];
  sinks: End[];
  implicit: boolean;
}

export interface LaunchFile {
  file: string | null;
  text: string;
  at: Place | null;
  cut: boolean;
  nodes: { name: string; package: string; type: string; conditions: string[]; at: Place }[];
  includes: LaunchFile[];
}

export interface Rate {
  topic: string;
  low: number;
  high: number | null;
  senders: string[];
  reasons: string[];
}

export interface System {
  name: string;
  nodes: SystemNode[];
  connectors: Connector[];
  files: LaunchFile[];
  rates: Rate[];
  /** Null when data flow was not followed. */
  steps: InfluenceStep[] | null;
}

/** From one port to the next in a chain: `how` is data or control, `kind` connection, answer, reactive, deferred or kept; then whether it is certain. */
export type InfluenceStep = [from: End, to: End, how: string, kind: string, certain: boolean];

export interface Evidence {
  text: string;
  at: Place;
  /** Where in the line the token is that is meant. */
  mark: [number, number] | null;
}

export interface Finding {
  id: string;
  check: string;
  severity: Severity;
  message: string;
  systems: string[];
  evidence: Evidence[];
  reason?: string;
}

export interface Check {
  title: string;
  description: string;
  scenario: string;
  recommendation: string;
}

export interface Diagnostic {
  kind: string;
  message: string;
  at: Place;
}

/** A run of lines: the number of the first, and the texts. */
export type Run = [number, string[]];

/** A step of a proof: text, rule (or what else it is), numbers of the steps it rests on, 1 where more is left out, the number of its place if it has one. */
export type ProofStep = [text: string, rule: string, premises: number[], cut: 0 | 1, place?: number];

/** Proofs; those of the things of a component or system are found by its name and their keys, see models/derivations.py. */
export interface Proofs {
  steps: ProofStep[];
  places: Place[];
  roots: Record<string, Record<string, number>>;
}

export interface ReportDocument {
  rosarch: string;
  title: string;
  link: string | null;
  components: Component[];
  systems: System[];
  findings: { shown: Finding[]; suppressed: Finding[]; checks: Record<string, Check> };
  diagnostics: Diagnostic[];
  sources: Record<string, Run[]>;
  /** Pages from disk have them in a block of their own. */
  proofs?: Proofs;
}

/** The text of a block of the page that `packed` of reports/html/page.py made. */
export async function unpack(id: string): Promise<string> {
  const block = document.getElementById(id)?.textContent ?? "";
  const bytes = Uint8Array.from(atob(block), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).text();
}
