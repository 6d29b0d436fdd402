/** The choice of a system, where a page is about one. */
import { useReport } from "../context";
import type { System } from "../data";
import { type Route, setParams } from "../route";
import { ending } from "./text";

/** The system that the address names, or else the largest one. */
export function useSystem(route: Route): System | undefined {
  const { systems } = useReport().document;
  const wanted = route.params.get("system");
  const largest = systems.reduce<System | undefined>(
    (best, each) => (best && best.nodes.length >= each.nodes.length ? best : each),
    undefined,
  );
  return systems.find(({ name }) => name === wanted) ?? largest;
}

const MOST = 44;

/** Parameters that name something in one system. */
const OF_ONE_SYSTEM = { focus: null, at: null, groups: null, from: null, to: null };

export function SystemChoice({ system }: { system: System }) {
  const { systems } = useReport().document;
  if (systems.length < 2) return null;
  return (
    <select
      aria-label="System"
      class="system"
      value={system.name}
      onChange={(event) => setParams({ ...OF_ONE_SYSTEM, system: event.currentTarget.value })}
    >
      {systems.map(({ name, nodes }) => (
        <option key={name} value={name}>
          {ending(name, MOST)} ({nodes.length})
        </option>
      ))}
    </select>
  );
}

export function NoSystem({ title }: { title: string }) {
  return (
    <>
      <h1>{title}</h1>
      <p class="muted">No launch file starts anything here.</p>
    </>
  );
}
