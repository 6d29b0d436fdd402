/** What becomes of messages between a port and others: the queue, in ROS 2 the quality of service. */
import type { Port } from "../data";
import { Maybe } from "./text";

/** Policies in the order in which people tell them; the depth is the queue. */
const FIRST = ["history", "reliability", "durability"];
/** What is so in most profiles, and is not told. */
const USUAL: Record<string, readonly string[]> = {
  reliability: ["reliable"],
  durability: ["volatile"],
  profile: ["default", "services"],
};

/** The policies of a port as words, but for what is usual unless `all` are wanted; none for ports of ROS 1. */
export function qualityWords({ qos, queue }: Port, all = false): string[] {
  if (!qos) return [];
  const told = Object.keys(qos).filter((policy) => all || !USUAL[policy]?.includes(qos[policy] ?? ""));
  const rest = told.filter((policy) => !FIRST.includes(policy)).sort();
  return [...FIRST.filter((policy) => told.includes(policy)), ...rest].flatMap((policy) => {
    const setting = qos[policy]?.replaceAll("_", " ") ?? "";
    if (policy === "history") {
      if (setting !== "keep last") return [setting];
      return queue !== null ? [`last ${queue}`] : all ? [setting] : [];
    }
    return [FIRST.includes(policy) ? setting : `${policy} ${setting}`];
  });
}

/** The queue of a port, or its quality of service. */
export function Quality({ port }: { port: Port }) {
  if (port.qos) {
    const words = qualityWords(port);
    const all = qualityWords(port, true).join(", ");
    return words.length ? <span title={all}>{words.join(", ")}</span> : <span class="none">usual</span>;
  }
  return (
    <>
      <Maybe text={port.queue} />
      {port.latched && <span class="tag">latched</span>}
    </>
  );
}
