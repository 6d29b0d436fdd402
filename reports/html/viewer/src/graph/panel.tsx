/** What is known of the box or connector that is selected, and what can be done with it. */

import { useReport } from "../context";
import type { End, Port, System, SystemNode } from "../data";
import { amount, counted, portKey, rateText } from "../model";
import { SeverityBadge } from "../parts/controls";
import { componentKind, PortKind, portLabel } from "../parts/kinds";
import { Why, WhyRate, WhyStarted } from "../parts/proof";
import { qualityWords } from "../parts/quality";
import { Source } from "../parts/source";
import { Condition, Name, shortened } from "../parts/text";
import { componentHref, href, setParams } from "../route";
import type { Box, ShownConnector, ShownGraph } from "./build";
import { reasonKey } from "./chains";

interface Props {
  id: string;
  graph: ShownGraph;
  system: System;
  onClose: () => void;
  onGroup: (group: string) => void;
}

export function Panel({ id, graph, system, onClose, onGroup }: Props) {
  const box = graph.boxes.get(id);
  const connector = graph.connectors.get(id);
  if (!box && !connector) return null;
  return (
    <aside class="panel" aria-label="Details">
      <button type="button" class="quiet close" onClick={onClose} aria-label="Close details">
        ✕
      </button>
      {box && (box.isGroup ? <GroupDetails box={box} onGroup={onGroup} /> : <NodeDetails box={box} system={system} />)}
      {connector && <ConnectorDetails shown={connector} system={system} />}
    </aside>
  );
}

function GroupDetails({ box, onGroup }: { box: Box; onGroup: (group: string) => void }) {
  return (
    <>
      <h2>
        <Name text={box.label} />
      </h2>
      <p class="muted">{counted(box.nodes.length, "node")}</p>
      <p class="actions">
        <button type="button" onClick={() => onGroup(box.label)}>
          Open the group
        </button>
      </p>
      <ul class="plain">
        {box.nodes.map((node) => (
          <li key={node.name + node.lines.join()}>
            <Name text={node.name} />
          </li>
        ))}
      </ul>
    </>
  );
}

const ORIGINS: Record<SystemNode["origin"], string> = {
  source: "analysed from source",
  library: "known from the library of interfaces",
  unknown: "no model: neither source nor library tells its ports",
};

function NodeDetails({ box, system }: { box: Box; system: System }) {
  const report = useReport();
  const node = box.nodes[0];
  if (!node) return null;
  const own = node.component ? report.component.get(node.component) : undefined;
  const ownPort = (id: string) => own?.ports.find((port) => port.id === id);
  const findings = report.findingsOfNode(system, node);
  return (
    <>
      <h2>
        <Name text={node.name} />
      </h2>
      <p class="muted">
        <Name text={`${node.package}/${node.type}`} />,{" "}
        {own && `${componentKind(own.kind)}${own.middleware ? ` of ${own.middleware}` : ""}, `}
        {ORIGINS[node.origin]}
        {node.open && "; it may have more ports than are known"}
      </p>
      <p class="actions">
        {own && (
          <a class="button" href={componentHref(own.name)}>
            Open component
          </a>
        )}
        <button type="button" onClick={() => setParams({ focus: node.name })}>
          Only what is near
        </button>
      </p>
      {node.conditions.length > 0 && (
        <p>
          Started if <code>{shortened(node.conditions.join(" and "), 200)}</code>
        </p>
      )}
      <p>
        Started at{" "}
        {node.lines.map((line, at) => (
          <span key={line}>
            {at > 0 && " › "}
            <Source at={line} />
          </span>
        ))}{" "}
        <WhyStarted system={system} node={node} />
      </p>
      {findings[0] && (
        <p>
          <a href={href(["findings"], { filter: node.name, system: system.name })}>
            <SeverityBadge severity={findings[0].severity} count={findings.length} />
          </a>
        </p>
      )}
      {node.rates.length > 0 && (
        <p>
          Loops and timers:{" "}
          {node.rates.map(([place, hz]) => (
            <span key={place}>
              {amount(hz)} Hz <Source at={place} />{" "}
            </span>
          ))}
        </p>
      )}
      <ul class="ports">
        {node.ports
          .filter((port) => !port.implicit)
          .map((port) => (
            <li key={port.id}>
              <div>
                <PortKind kind={port.kind} />
                <span>
                  <Source at={port.at} />
                  {node.origin === "source" && node.component && port.at && (
                    <Why
                      owner={node.component}
                      of={`port ${portKey(ownPort(port.id))}`}
                      title={`${portLabel(port.kind)} ${port.name}`}
                    />
                  )}
                </span>
              </div>
              <Name text={port.name} strong />
              <div class="muted">
                <Name text={port.type ?? "type not known"} />
                <Flow port={ownPort(port.id)} />
                {port.written !== port.name && (
                  <div>
                    in the code <code>{shortened(port.written, 80)}</code>
                  </div>
                )}
              </div>
              {port.conditional && (
                <div>
                  if <Condition text={port.conditional} />
                </div>
              )}
            </li>
          ))}
      </ul>
    </>
  );
}

/** The queue of a port, or its quality of service. */
function Flow({ port }: { port: Port | undefined }) {
  if (!port) return null;
  const queue = port.queue === null ? [] : [`queue ${port.queue}`];
  const words = port.qos ? qualityWords(port) : [...queue, ...(port.latched ? ["latched"] : [])];
  return words.length ? <div>{words.join(", ")}</div> : null;
}

const MOST = 30;

function ConnectorDetails({ shown, system }: { shown: ShownConnector; system: System }) {
  return (
    <>
      {shown.connectors.slice(0, MOST).map((connector) => {
        const rate = system.rates.find(({ topic }) => topic === connector.name);
        const asked = connector.kind === "service" || connector.kind === "action";
        return (
          <section key={connector.name}>
            <h2>
              <Name text={connector.name} />
            </h2>
            <p class="muted">
              {connector.kind},{" "}
              {connector.types.length ? <Name text={connector.types.join(" or ")} /> : "type not known"}
              {rate && `, ${rateText(rate)}${rate.high === null && !rate.low ? " rate" : " messages a second"} `}
              {rate && <WhyRate system={system} rate={rate} />}
            </p>
            <Ends title={asked ? "Called by" : "Sent by"} ends={connector.sources} system={system} />
            <Ends title={asked ? "Served by" : "Received by"} ends={connector.sinks} system={system} />
          </section>
        );
      })}
      {shown.connectors.length > MOST && <p class="muted">and {shown.connectors.length - MOST} more</p>}
    </>
  );
}

function Ends({ title, ends, system }: { title: string; ends: End[]; system: System }) {
  const { component: components } = useReport();
  return (
    <>
      <h3>{title}</h3>
      {ends.length ? (
        <ul class="plain">
          {ends.map(([at, number]) => {
            const node = system.nodes[at];
            const port = node?.ports[number];
            return (
              <li key={`${at} ${number}`}>
                <button type="button" class="place" onClick={() => setParams({ at: `node:${at}` })}>
                  {shortened(node?.name ?? "", 80)}
                </button>{" "}
                {port?.at && <Source at={port.at} />}
                {port && !port.implicit && (
                  <Why
                    owner={system.name}
                    of={`end ${port.name} ${reasonKey(system, [at, number])}`}
                    title={`${node?.name} at ${port.name}`}
                  />
                )}
                <div class="muted">
                  <Flow
                    port={
                      node?.component
                        ? components.get(node.component)?.ports.find(({ id }) => id === port?.id)
                        : undefined
                    }
                  />
                </div>
              </li>
            );
          })}
        </ul>
      ) : (
        <p class="muted">nobody that is known</p>
      )}
    </>
  );
}
