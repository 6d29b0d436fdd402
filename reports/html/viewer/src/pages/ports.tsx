/** The ports of a component. */
import type { Component, Port } from "../data";
import { counted, portKey } from "../model";
import { Section, Table } from "../parts/controls";
import { PortKind, portLabel, portOrder } from "../parts/kinds";
import { Why } from "../parts/proof";
import { Quality } from "../parts/quality";
import { Source } from "../parts/source";
import { Condition, Name, shortened } from "../parts/text";

export function Ports({ component }: { component: Component }) {
  const own = component.ports.filter((port) => !port.implicit).sort((a, b) => portOrder(a.kind) - portOrder(b.kind));
  const implicit = component.ports.filter((port) => port.implicit);
  return (
    <Section id="ports" title="Ports" count={own.length}>
      {own.length > 0 ? (
        <PortTable owner={component.name} ports={own} label="Ports" />
      ) : (
        <p class="muted">It has none.</p>
      )}
      {implicit.length > 0 && (
        <details>
          <summary>{counted(implicit.length, "port")} that libraries make inside themselves</summary>
          <PortTable owner={component.name} ports={implicit} label="Implicit ports" />
        </details>
      )}
    </Section>
  );
}

function PortTable({ owner, ports, label }: { owner: string; ports: readonly Port[]; label: string }) {
  const hasQuality = ports.some(({ qos }) => qos);
  const common = commonCondition(ports);
  return (
    <>
      {common && (
        <p>
          All of them only if <code class="condition">{shortened(common, 400)}</code>
        </p>
      )}
      <PortRows owner={owner} ports={ports} label={label} hasQuality={hasQuality} common={common} />
    </>
  );
}

/** The condition that those of all ports begin with, where there are several. */
function commonCondition(ports: readonly Port[]): string {
  const parts = ports.map(({ conditional }) => conditional?.split(AND) ?? []);
  const [first = []] = parts;
  const same = first.findIndex((part, at) => parts.some((each) => each[at] !== part));
  return ports.length > 1 ? first.slice(0, same < 0 ? first.length : same).join(AND) : "";
}

const AND = " && ";

interface PortRowsProps {
  owner: string;
  ports: readonly Port[];
  label: string;
  hasQuality: boolean;
  common: string;
}

/** Ports as a table, without columns that would have nothing in them. */
function PortRows({ owner, ports, label, hasQuality, common }: PortRowsProps) {
  const own = (port: Port) => port.conditional?.slice(common ? common.length + AND.length : 0);
  const called = ports.some((port) => port.callback || isTold(port.via));
  const conditional = ports.some(own);
  const head = [
    ...["Kind", "Name", "Type", hasQuality ? "Quality of service" : "Queue"],
    ...(called ? ["Callback"] : []),
    ...(conditional ? ["If"] : []),
    "Source",
  ];
  return (
    <Table label={label} head={head}>
      {ports.map((port) => (
        <tr key={port.id} id={`port-${port.id}`}>
          <td>
            <PortKind kind={port.kind} />
          </td>
          <td>
            <PortName port={port} />
          </td>
          <td>{port.type ? <Name text={port.type} /> : <span class="none">not known</span>}</td>
          <td>
            <Quality port={port} />
          </td>
          {called && (
            <td>
              {port.callback ? <code>{port.callback}</code> : <span class="none">–</span>}
              {isTold(port.via) && <span class="muted"> via {port.via}</span>}
            </td>
          )}
          {conditional && (
            <td>
              <Condition text={own(port)} />
            </td>
          )}
          <td class="whole">
            <Source at={port.at} />
            {!port.implicit && (
              <Why owner={owner} of={`port ${portKey(port)}`} title={`${portLabel(port.kind)} ${port.name}`} />
            )}
          </td>
        </tr>
      ))}
    </Table>
  );
}

/** Whether the way to a callback is none of the usual ones. */
const isTold = (via: string): boolean => !["plain", "lambda", ""].includes(via);

function PortName({ port }: { port: Port }) {
  return (
    <>
      <Name text={port.name} strong />
      {port.from_param && (
        <div class="muted">
          from parameter <code>{port.from_param}</code>
        </div>
      )}
      {port.unknown && <div class="muted">not known: {port.unknown}</div>}
    </>
  );
}
