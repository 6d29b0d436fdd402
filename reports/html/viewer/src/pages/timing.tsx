/** How often topics of a system are sent on, and what influences what. */
import { useMemo } from "preact/hooks";
import { useReport } from "../context";
import type { End, Rate, System } from "../data";
import { endKey, endName, endsOf, findChain, reasonKey } from "../graph/chains";
import { counted, portKey, rateText } from "../model";
import { Filter, matches, Table } from "../parts/controls";
import { CONNECTOR_KINDS, portLabel } from "../parts/kinds";
import { Why, WhyRate } from "../parts/proof";
import { Source } from "../parts/source";
import { NoSystem, SystemChoice, useSystem } from "../parts/system";
import { Name, shortened } from "../parts/text";
import { href, type Route, setParams } from "../route";

export function TimingPage({ route }: { route: Route }) {
  const system = useSystem(route);
  if (!system) return <NoSystem title="Rates and chains" />;
  const filter = route.params.get("filter") ?? "";
  const inside = new Set(system.connectors.filter(({ implicit }) => implicit).map(({ name }) => name));
  const own = system.rates.filter(({ topic }) => !inside.has(topic));
  const shown = own.filter((rate) => matches(filter, rate.topic, ...rate.senders)).sort(byKnowledge);
  return (
    <>
      <h1>Rates and chains</h1>
      <div class="controls">
        <SystemChoice system={system} />
      </div>
      <Chains system={system} route={route} />
      <h2>How often something is sent</h2>
      <div class="controls">
        <Filter label="Filter by topic or sender" param="filter" value={filter} />
      </div>
      <Table label="Rates of topics" head={["Topic", "Messages a second", "Sent by", "Remarks"]}>
        {shown.map((rate) => (
          <tr key={rate.topic}>
            <td>
              <Name text={rate.topic} strong />
            </td>
            <td class="number">
              {rateText(rate)} <WhyRate system={system} rate={rate} />
            </td>
            <td class="names-list">
              {rate.senders.map((sender) => (
                <Name key={sender} text={sender} />
              ))}
            </td>
            <td class="muted">{rate.high === 0 && rate.senders.length ? SELDOM : rate.reasons.join("; ")}</td>
          </tr>
        ))}
      </Table>
      {own.length < system.rates.length && (
        <p class="muted more">
          Not shown: {counted(system.rates.length - own.length, "topic")} that only libraries send on or read.
        </p>
      )}
    </>
  );
}

const SELDOM = "no clock and no message is known to set it off";

/** What is known first. */
const byKnowledge = (a: Rate, b: Rate) => knowledge(a) - knowledge(b);
const knowledge = ({ low, high }: Rate) => (high === 0 ? 2 : high !== null ? 0 : low ? 1 : 3);

const DOES: Record<string, string> = {
  connection: "arrives at",
  answer: "is answered to",
  reactive: "makes it send",
  deferred: "is sent in a loop or timer by",
  kept: "is kept until something makes it send",
};

function Chains({ system, route }: { system: System; route: Route }) {
  const [from, to] = [route.params.get("from") ?? "", route.params.get("to") ?? ""];
  const chain = useMemo(() => (from && to ? findChain(system, from, to) : null), [system, from, to]);
  if (!system.steps) {
    return (
      <p class="muted">
        Chains of cause and effect are told by a report that is made with <code>--chains</code>.
      </p>
    );
  }
  return (
    <>
      <h2>What influences what</h2>
      <div class="controls">
        <EndChoice system={system} side="from" label="What passes through" value={from} />
        <EndChoice system={system} side="to" label="has an influence on" value={to} />
      </div>
      {from && to && !chain && <p class="muted">No chain leads there, as far as is known.</p>}
      {chain && (
        <>
          <p>
            {chain.certain ? "Always, as long as no message is lost. " : "It can. "}
            <a href={href(["graph"], { system: system.name, from, to, kinds: CONNECTOR_KINDS.join() })}>
              Show it in the graph
            </a>
          </p>
          <ol class="chain">
            {chain.steps.map(([source, sink, how, kind, certain], at) => (
              <li key={`${at}`}>
                <ChainEnd system={system} end={source} />
                <div class="muted">
                  ↓ {DOES[kind] ?? kind}
                  {kind !== "connection" && `, through ${how}`}
                  {certain ? ", always" : ""} <WhyStep system={system} source={source} sink={sink} />
                </div>
                {at === chain.steps.length - 1 && <ChainEnd system={system} end={sink} />}
              </li>
            ))}
          </ol>
        </>
      )}
    </>
  );
}

function WhyStep({ system, source, sink }: { system: System; source: End; sink: End }) {
  const report = useReport();
  const [node, other] = [system.nodes[source[0]], system.nodes[sink[0]]];
  const step = `${reasonKey(system, source)} > ${reasonKey(system, sink)}`;
  const own = node === other && node?.component ? report.component.get(node.component) : undefined;
  const ports = [source, sink].map(([, number]) => own?.ports.find(({ id }) => id === node?.ports[number]?.id));
  const inside = own ? [{ owner: own.name, key: `flow ${ports.map(portKey).join(" > ")}` }] : [];
  return (
    <Why
      owner={system.name}
      of={[`chain_step ${step}`, `certain_step ${step}`]}
      more={inside}
      title={`${endName(system, source)} → ${endName(system, sink)}`}
    />
  );
}

function ChainEnd({ system, end: [at, number] }: { system: System; end: End }) {
  const node = system.nodes[at];
  const port = node?.ports[number];
  return (
    <div>
      <Name text={port?.name ?? ""} strong /> <span class="muted">{portLabel(port?.kind ?? "")} of</span>{" "}
      <Name text={node?.name ?? ""} /> {port?.at && <Source at={port.at} />}
    </div>
  );
}

function EndChoice({
  system,
  side,
  label,
  value,
}: {
  system: System;
  side: "from" | "to";
  label: string;
  value: string;
}) {
  const ends = useMemo(() => endsOf(system, side), [system, side]);
  return (
    <label>
      {label}{" "}
      <select value={value} onChange={(event) => setParams({ [side]: event.currentTarget.value })}>
        <option value="">…</option>
        {ends.map((end) => (
          <option key={endKey(system, end)} value={endKey(system, end)}>
            {shortened(endName(system, end), 80)}
          </option>
        ))}
      </select>
    </label>
  );
}
