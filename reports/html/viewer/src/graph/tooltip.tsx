/** What hovering tells: type, rate, lines. */
import type { System } from "../data";
import { amount, counted, rateText } from "../model";
import { shortened } from "../parts/text";
import type { ShownGraph } from "./build";

interface Props {
  id: string;
  x: number;
  y: number;
  graph: ShownGraph;
  system: System;
}

export function Tooltip({ id, x, y, graph, system }: Props) {
  const place = (element: HTMLDivElement | null) => {
    if (!element) return;
    element.style.left = `${Math.max(8, Math.min(x, (element.parentElement?.clientWidth ?? 0) - element.offsetWidth - 8))}px`;
    element.style.top = `${Math.max(8, Math.min(y, (element.parentElement?.clientHeight ?? 0) - element.offsetHeight - 8))}px`;
  };
  return (
    <div class="tooltip" ref={place} role="tooltip">
      {linesOf(id, graph, system).map((text, at) => (
        <div key={`${at}`} class={at ? "muted" : "strong"}>
          {shortened(text, 90)}
        </div>
      ))}
    </div>
  );
}

function linesOf(id: string, graph: ShownGraph, system: System): string[] {
  const box = graph.boxes.get(id);
  if (box?.isGroup) return [box.label, ...box.nodes.slice(0, 8).map((node) => node.name)];
  const node = box?.nodes[0];
  if (node) {
    const rates = node.rates.map(([place, hz]) => `${amount(hz)} Hz at ${place}`);
    return [
      node.name,
      `${node.package}/${node.type}`,
      counted(node.ports.length, "port"),
      ...rates,
      ...node.lines.slice(-1),
    ];
  }
  const connectors = graph.connectors.get(id)?.connectors ?? [];
  return connectors.slice(0, 4).flatMap((connector) => {
    const rate = system.rates.find(({ topic }) => topic === connector.name);
    const ends = [...connector.sources, ...connector.sinks].flatMap(
      ([at, port]) => system.nodes[at]?.ports[port]?.at ?? [],
    );
    return [
      connector.name,
      connector.types.join(" or ") || "type not known",
      ...(rate ? [`rate: ${rateText(rate)}${rate.high !== null ? " Hz" : ""}`] : []),
      ...ends.slice(0, 4),
    ];
  });
}
