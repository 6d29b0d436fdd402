/** What becomes of messages between a port and others: the queue, in ROS 2 the quality of service. */
import type { Port } from "../data";
import { Maybe } from "./text";

/** Policies in the order in which people tell them; the depth is the queue. */
const FIRST = ["history", "reliability", "durability"];
const UNSAID: Record<string, string> = { profile: "default" };

/** The policies of a port as words; none for ports of ROS 1. */
export function qualityWords({ qos, queue }: Port): string[] {
  if (!qos) return [];
  const rest = Object.keys(qos).filter((policy) => !FIRST.includes(policy) && UNSAID[policy] !== qos[policy]);
  return [...FIRST, ...rest.sort()].flatMap((policy) => {
    const setting = qos[policy]?.replaceAll("_", " ");
    if (setting === undefined) return [];
    if (policy === "history") return [setting === "keep last" && queue !== null ? `${setting} ${queue}` : setting];
    return [FIRST.includes(policy) ? setting : `${policy} ${setting}`];
  });
}

/** The queue of a port, or its quality of service. */
export function Quality({ port }: { port: Port }) {
  const words = qualityWords(port);
  if (words.length) return <span>{words.join(", ")}</span>;
  return (
    <>
      <Maybe text={port.queue} />
      {port.latched && <span class="tag">latched</span>}
    </>
  );
}
