/** How often topics of a system are sent on, and what influences what. */
import { useMemo } from "preact/hooks";
import type { End, System } from "../data";
import { endKey, endName, endsOf, findChain } from "../graph/chains";
import { rateText } from "../model";
import { Filter, matches, Table } from "../parts/controls";
import { CONNECTOR_KINDS, portLabel } from "../parts/kinds";
import { Source } from "../parts/source";
import { NoSystem, SystemChoice, useSystem } from "../parts/system";
import { Name, shortened } from "../parts/text";
import { href, type Route, setParams } from "../route";

export function TimingPage({ route }: { route: Route }) {
  const system = useSystem(route);
  if (!system) return <NoSystem title="Rates and chains" />;
  const filter = route.params.get("filter") ?? "";
  const shown = system.rates.filter((rate) => matches(filter, rate.topic, ...rate.senders));
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
      <Table label="Rates of topics" head={["Topic", "Messages a second", "Sent by", "Why it is not known"]}>
        {shown.map((rate) => (
          <tr key={rate.topic}>
            <td>
              <Name text={rate.topic} strong />
            </td>
            <td class="number">{rateText(rate)}</td>
            <td>
              <Name text={rate.senders.join(", ")} />
            </td>
            <td class="muted">{rate.reasons.join("; ")}</td>
          </tr>
        ))}
      </Table>
    </>
  );
}

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
                  {certain ? ", always" : ""}
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
