/** One component: ports, parameters, rates, behaviour, state machines, findings. */

import { useReport } from "../context";
import type { Component, ReportDocument } from "../data";
import { Machines } from "../machine/machines";
import { amount, counted, frequency, grouped, type Instance, portKey, portsById, sentIn } from "../model";
import { Section, Table } from "../parts/controls";
import { componentKind } from "../parts/kinds";
import { Why } from "../parts/proof";
import { Source, Sources } from "../parts/source";
import { Condition, Maybe, Name, shortened } from "../parts/text";
import { componentHref, href } from "../route";
import { FindingCard } from "./findings";
import { Ports } from "./ports";

export function ComponentPage({ name }: { name: string }) {
  const report = useReport();
  const component = report.component.get(name);
  if (!component) {
    return (
      <>
        <h1>
          <Name text={name} />
        </h1>
        <p class="muted">The report has no model of this component: it is not among the sources that were analysed.</p>
      </>
    );
  }
  const findings = report.findingsOf(component);
  const made = nodesOf(component, report.document);
  return (
    <>
      <p class="above">
        <a href={href(["components"])}>Components</a> / {component.package}
      </p>
      <h1>
        <Name text={component.component} />
      </h1>
      <p class="lead">
        <span class="begins">{componentKind(component.kind)}</span>
        {component.middleware && ` of ${component.middleware}`}
        {component.node_name && !made.length && (
          <>
            {" "}
            that calls itself <code>{component.node_name}</code>
          </>
        )}
        , in {counted(component.sources.length, "source")}.
      </p>
      <Programs component={component} made={made} />
      <Started instances={[component, ...made].flatMap((each) => report.instances.get(each.name) ?? [])} />
      <Ports component={component} />
      <Parameters component={component} />
      <Behaviour component={component} />
      <Machines owner={component.name} machine={component.machine} />
      <Variables component={component} />
      {findings.length > 0 && (
        <Section id="findings" title="Findings" count={findings.length}>
          {findings.map((finding) => (
            <FindingCard key={finding.id} finding={finding} />
          ))}
        </Section>
      )}
    </>
  );
}

/** The nodes of a program that makes several. */
const nodesOf = (program: Component, { components }: ReportDocument) =>
  components.filter((each) => each.package === program.package && each.executable === program.component);

/** How it is started: the program that it is part of or is made of, the names that it is loaded by. */
function Programs({ component, made }: { component: Component; made: readonly Component[] }) {
  const { document } = useReport();
  const { package: own, plugin, executable, executables = [] } = component;
  const program = document.components.find((each) => each.package === own && each.component === executable);
  const link = (other: Component) => <a href={componentHref(other.name)}>{shortened(other.component, 80)}</a>;
  return (
    <>
      {executable && (
        <p>
          One of the nodes of the program {program ? link(program) : <code>{executable}</code>}, of which only what
          belongs to this node is shown.
        </p>
      )}
      {made.length > 0 && (
        <p>
          The program makes {counted(made.length, "node")}:{" "}
          {made.map((node, at) => (
            <span key={node.name}>
              {at > 0 && ", "}
              {link(node)}
            </span>
          ))}
          . Here they are shown together.
        </p>
      )}
      {plugin && (
        <p>
          Loaded by the name of its class, <code>{plugin.name}</code>
          {plugin.base && (
            <>
              {" "}
              (<code>{plugin.base}</code>)
            </>
          )}
          .
        </p>
      )}
      {executables.length > 0 && (
        <p>
          {executables.length === 1 ? "Its executable is " : "Its executables are "}
          {executables.map((name, at) => (
            <span key={name}>
              {at > 0 && ", "}
              <code>{name}</code>
            </span>
          ))}
          .
        </p>
      )}
    </>
  );
}

function Started({ instances }: { instances: readonly Instance[] }) {
  if (!instances.length) return <p class="muted">No launch file that was composed starts it.</p>;
  return (
    <details class="started" open={instances.length <= 4}>
      <summary>Started as {counted(instances.length, "node")}</summary>
      <ul class="plain">
        {instances.map(({ system, node }) => (
          <li key={`${system.name} ${node.name} ${node.lines.join()}`}>
            <a href={href(["graph"], { system: system.name, focus: node.name })}>
              <Name text={node.name} />
            </a>{" "}
            <span class="muted">
              by <Name text={system.name} />
            </span>{" "}
            <Source at={node.lines.at(-1)} />
          </li>
        ))}
      </ul>
    </details>
  );
}

function Parameters({ component }: { component: Component }) {
  const all = [...component.params, ...component.reconfigurable];
  if (!all.length) return null;
  return (
    <Section id="parameters" title="Parameters" count={new Set(all.map((each) => each.name)).size}>
      <Table label="Parameters" head={["Name", "Type", "Default", "Where"]}>
        {[...grouped(all, ({ name }) => name)].map(([name, accesses]) => (
          <tr key={name}>
            <td>
              <Name text={name} strong />
            </td>
            <td>
              <Maybe text={distinct(accesses.map(({ type }) => type?.replace(/^\?/, "")))} />
            </td>
            <td>
              {accesses.some((each) => each.default !== null) ? (
                <code>{distinct(accesses.map((each) => each.default))}</code>
              ) : (
                <span class="none">none</span>
              )}
            </td>
            <td>
              {accesses.map((access, at) => (
                <div key={`${at}`}>
                  <span class="muted">{access.op ?? "reconfigured"}</span> <Source at={access.at} />
                  {access.op && (
                    <Why
                      owner={component.name}
                      of={`parameter ${access.op} ${name} ${access.at}`}
                      title={`parameter ${name}`}
                    />
                  )}
                </div>
              ))}
            </td>
          </tr>
        ))}
      </Table>
    </Section>
  );
}

/** Values as a text, each once. */
function distinct(values: readonly (string | number | boolean | null | undefined)[]): string {
  return [...new Set(values.filter((value) => value !== null && value !== undefined).map(String))].join(" or ");
}

function Behaviour({ component }: { component: Component }) {
  const ports = portsById(component);
  const names = (ids: readonly string[]) =>
    ids.map((id, at) => (
      <span key={id}>
        {at > 0 && ", "}
        <Name text={ports.get(id)?.name ?? id} />
      </span>
    ));
  const { periodic, reactive, one_shot, reactive_deferred } = component;
  if (!periodic.length && !reactive.length && !one_shot.length && !reactive_deferred.length) return null;
  return (
    <Section id="behaviour" title="Behaviour">
      {periodic.length > 0 && (
        <>
          <h3>Timed loops and timers</h3>
          <Table label="Timed loops and timers" head={["Rate", "By", "Sends", "If", "Source"]}>
            {periodic.map((loop, at) => (
              <tr key={`${at}`}>
                <td>
                  {frequency(loop.hz)}
                  {loop.hz_from_param && (
                    <div class="muted">
                      from <code>{loop.hz_from_param}</code>
                    </div>
                  )}
                </td>
                <td>{loop.mechanism}</td>
                <td>{sentIn(loop).length ? names(sentIn(loop)) : <span class="none">nothing</span>}</td>
                <td>
                  <Condition text={loop.conditional} />
                </td>
                <td>
                  <Source at={loop.at} />
                  <Why
                    owner={component.name}
                    of={`periodic ${loop.at}`}
                    title={`${loop.mechanism}, ${frequency(loop.hz)}`}
                  />
                </td>
              </tr>
            ))}
          </Table>
        </>
      )}
      {reactive.length > 0 && (
        <>
          <h3>Reactions</h3>
          <Table label="Reactions" head={["On", "Sends", "", "If", "Source"]}>
            {reactive.map((reaction, at) => (
              <tr key={`r${at}`}>
                <td>{names([reaction.input])}</td>
                <td>{names([reaction.output])}</td>
                <td>{reaction.must ? "always" : "may"}</td>
                <td>
                  <Condition text={reaction.when} />
                </td>
                <td>
                  <Sources at={reaction.at} />
                  <Why
                    owner={component.name}
                    of={`reacts ${[reaction.input, reaction.output].map((id) => portKey(ports.get(id))).join(" > ")}`}
                    title={`${ports.get(reaction.input)?.name} → ${ports.get(reaction.output)?.name}`}
                  />
                </td>
              </tr>
            ))}
          </Table>
        </>
      )}
      {one_shot.length > 0 && (
        <>
          <h3>Timers that run once</h3>
          <Table label="Timers that run once" head={["After", "Sends", "", "If", "Timer", "Sent at"]}>
            {one_shot.map((shot, at) => (
              <tr key={`o${at}`}>
                <td>
                  {shot.after === null ? <span class="none">not known</span> : `${amount(shot.after)} s`}
                  {shot.after_from_param && (
                    <div class="muted">
                      from <code>{shot.after_from_param}</code>
                    </div>
                  )}
                </td>
                <td>{names([shot.output])}</td>
                <td>{shot.must ? "always" : "may"}</td>
                <td>
                  <Condition text={shot.when} />
                </td>
                <td>
                  <Source at={shot.at} />
                  <Why
                    owner={component.name}
                    of={`once ${shot.at} > ${portKey(ports.get(shot.output))}`}
                    title={`timer, once → ${ports.get(shot.output)?.name}`}
                  />
                </td>
                <td>
                  <Sources at={shot.sent_at} />
                </td>
              </tr>
            ))}
          </Table>
        </>
      )}
      {reactive_deferred.length > 0 && (
        <>
          <h3>Kept and sent later</h3>
          <Table label="Kept and sent later" head={["What arrives at", "is kept in", "and sent on", "Source"]}>
            {reactive_deferred.map((deferred, at) => (
              <tr key={`${at}`}>
                <td>{names([deferred.input])}</td>
                <td>
                  <code>{deferred.variable}</code>
                </td>
                <td>{names([deferred.output])}</td>
                <td>
                  <Source at={ports.get(deferred.output)?.at} />
                  <Why
                    owner={component.name}
                    of={`kept ${[deferred.input, deferred.output].map((id) => portKey(ports.get(id))).join(" > ")} in ${deferred.variable}`}
                    title={`${ports.get(deferred.input)?.name} → ${ports.get(deferred.output)?.name}`}
                  />
                </td>
              </tr>
            ))}
          </Table>
        </>
      )}
    </Section>
  );
}

function Variables({ component }: { component: Component }) {
  const rows = [
    ...component.state_variables.map((variable) => ({ variable, role: "state" })),
    ...component.configuration.map((variable) => ({ variable, role: "configuration" })),
  ];
  if (!rows.length) return null;
  return (
    <Section id="variables" title="Variables that decide" count={rows.length}>
      <Table label="Variables that decide" head={["Variable", "Role", "Type", "Begins as", "Values", "Source"]}>
        {rows.map(({ variable, role }) => (
          <tr key={`${role} ${variable.name} ${variable.at}`}>
            <td>
              <Name text={variable.name} strong />
            </td>
            <td>{role}</td>
            <td>
              <Name text={variable.type} />
            </td>
            <td>
              {variable.initial === null ? <span class="none">not known</span> : <code>{variable.initial}</code>}
              {variable.from_param && (
                <div class="muted">
                  from <code>{variable.from_param}</code>
                </div>
              )}
            </td>
            <td>
              {variable.domain ? <code>{variable.domain.join(", ")}</code> : <span class="none">not listed</span>}
            </td>
            <td>
              <Source at={variable.at} />
              <Why owner={component.name} of={`variable ${variable.at}`} title={`variable ${variable.name}`} />
            </td>
          </tr>
        ))}
      </Table>
    </Section>
  );
}
