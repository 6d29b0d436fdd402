/** Chains of cause and effect through a system, from the steps that the rules derived. */
import type { End, InfluenceStep, System } from "../data";

export interface Chain {
  steps: InfluenceStep[];
  certain: boolean;
}

export function endName(system: System, [at, number]: End): string {
  const node = system.nodes[at];
  return `${node?.name ?? ""} ${node?.ports[number]?.name ?? ""}`;
}

/** Ends as the address has them: the node's name and the port's id. */
export function endKey(system: System, [at, number]: End): string {
  const node = system.nodes[at];
  return `${node?.name ?? ""} ${node?.ports[number]?.id ?? ""}`;
}

/** Ends as the keys of proofs have them; see models/system/reasons.py. */
export function reasonKey(system: System, [at, number]: End): string {
  const node = system.nodes[at];
  return `${node?.id} ${node?.component}#${node?.ports[number]?.id}`;
}

/** The ends at which steps begin, or end. */
export function endsOf(system: System, side: "from" | "to"): End[] {
  const found = new Map<string, End>();
  for (const [from, to] of system.steps ?? []) {
    const end = side === "from" ? from : to;
    found.set(endKey(system, end), end);
  }
  return [...found.values()].sort((a, b) => endName(system, a).localeCompare(endName(system, b)));
}

/** The shortest chain between two ends; null when there is none. */
export function findChain(system: System, from: string, to: string): Chain | null {
  const after = new Map<string, InfluenceStep[]>();
  for (const step of system.steps ?? []) {
    const key = endKey(system, step[0]);
    after.set(key, [...(after.get(key) ?? []), step]);
  }
  const reached = new Map<string, InfluenceStep | null>([[from, null]]);
  for (const at of reached.keys()) {
    for (const step of after.get(at) ?? []) {
      const next = endKey(system, step[1]);
      if (!reached.has(next)) reached.set(next, step);
    }
    if (reached.has(to)) break;
  }
  if (from === to || !reached.has(to)) return null;
  const steps: InfluenceStep[] = [];
  for (let step = reached.get(to); step; step = reached.get(endKey(system, step[0]))) steps.unshift(step);
  return { steps, certain: steps.every(([, , , , certain]) => certain) };
}
