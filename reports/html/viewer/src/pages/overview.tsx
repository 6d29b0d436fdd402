/** What was analysed, what was found, and what is not known and why. */

import { useState } from "preact/hooks";
import { useReport } from "../context";
import type { Diagnostic, ReportDocument } from "../data";
import { counted, grouped, SEVERITIES } from "../model";
import { Section, SeverityBadge, Table } from "../parts/controls";
import { portLabel } from "../parts/kinds";
import { Source } from "../parts/source";
import { Name, shortened } from "../parts/text";
import { componentHref, href } from "../route";

const MOST = 12;

export function OverviewPage() {
  const { document } = useReport();
  const components = programs(document);
  const packages = new Set(components.map((component) => component.package)).size;
  const ports = components.reduce((sum, { ports }) => sum + ports.filter((port) => !port.implicit).length, 0);
  const middlewares = [...new Set(components.flatMap(({ middleware }) => middleware ?? []))].sort();
  return (
    <>
      <h1>
        <Name text={document.title} />
      </h1>
      <p class="lead">
        {counted(components.length, "component")}
        {middlewares.length > 0 && ` of ${middlewares.join(" and ")}`} in {counted(packages, "package")} with{" "}
        {counted(ports, "port")}; {counted(document.systems.length, "system")} that launch files start.
      </p>
      <Found document={document} />
      <Systems document={document} />
      <Unknown document={document} />
      <p class="muted foot">
        Made by rosarch {document.rosarch} from the sources alone: nothing was built or run. What is shown holds for
        what was read; what could not be read is told above.
      </p>
    </>
  );
}

/** The components, without nodes of programs that have several: they are in the program. */
const programs = (document: ReportDocument) => document.components.filter(({ executable }) => !executable);

function Found({ document }: { document: ReportDocument }) {
  const { shown, suppressed, checks } = document.findings;
  const byCheck = grouped(shown, (finding) => finding.check);
  const frequent = [...byCheck].sort(([, a], [, b]) => b.length - a.length).slice(0, MOST);
  return (
    <Section id="found" title="Findings" count={shown.length}>
      <p class="badges">
        {SEVERITIES.map((severity) => (
          <a key={severity} href={href(["findings"], { severity })}>
            <SeverityBadge severity={severity} count={shown.filter((found) => found.severity === severity).length} />
          </a>
        ))}
        {suppressed.length > 0 && <span class="muted">{suppressed.length} suppressed by comments</span>}
      </p>
      {frequent.length > 0 && (
        <Table label="Findings by check" head={["Check", "What it finds", "Findings"]}>
          {frequent.map(([check, found]) => (
            <tr key={check}>
              <td class="whole">
                <a href={href(["findings"], { check })}>{check}</a>
              </td>
              <td>{checks[check]?.title}</td>
              <td class="number">
                {SEVERITIES.filter((severity) => found.some((each) => each.severity === severity)).map((severity) => (
                  <SeverityBadge
                    key={severity}
                    severity={severity}
                    count={found.filter((each) => each.severity === severity).length}
                  />
                ))}
              </td>
            </tr>
          ))}
        </Table>
      )}
      {byCheck.size > MOST && <p class="muted more">and {byCheck.size - MOST} other checks</p>}
    </Section>
  );
}

function Systems({ document }: { document: ReportDocument }) {
  const [whole, setWhole] = useState(false);
  const all = [...document.systems].sort((a, b) => b.nodes.length - a.nodes.length);
  const shown = whole ? all : all.slice(0, MOST);
  if (!document.systems.length) {
    return (
      <Section id="systems" title="Systems">
        <p class="muted">No launch file starts anything here; components are shown by themselves.</p>
      </Section>
    );
  }
  const found = (name: string) => document.findings.shown.filter((finding) => finding.systems.includes(name)).length;
  return (
    <Section id="systems" title="Systems" count={document.systems.length}>
      <Table
        label="Systems"
        head={["Launch file and arguments", "Nodes", "Without model", "Connectors", "Findings", "Files"]}
      >
        {shown.map((system) => (
          <tr key={system.name}>
            <td>
              <a href={href(["graph"], { system: system.name })}>
                <Name text={system.name} />
              </a>
            </td>
            <td class="number">{system.nodes.length}</td>
            <td class="number">
              {system.nodes.filter((node) => node.origin === "unknown").length || <span class="none">–</span>}
            </td>
            <td class="number">{system.connectors.filter((connector) => !connector.implicit).length}</td>
            <td class="number">
              {found(system.name) ? (
                <a href={href(["findings"], { system: system.name })}>{found(system.name)}</a>
              ) : (
                <span class="none">–</span>
              )}
            </td>
            <td class="whole">
              <a href={href(["launch"], { system: system.name })}>launch tree</a>
            </td>
          </tr>
        ))}
      </Table>
      {all.length > MOST && (
        <p class="more">
          <button type="button" aria-expanded={whole} onClick={() => setWhole(!whole)}>
            {whole ? "Only the largest systems" : `All ${all.length} systems`}
          </button>
        </p>
      )}
    </Section>
  );
}

function Unknown({ document }: { document: ReportDocument }) {
  const ports = programs(document).flatMap((component) =>
    component.ports.filter((port) => port.unknown).map((port) => ({ component, port })),
  );
  const missing = new Map<string, Set<string>>();
  for (const system of document.systems) {
    for (const node of system.nodes) {
      if (node.origin !== "unknown") continue;
      const program = `${node.package}/${node.type}`;
      missing.set(program, (missing.get(program) ?? new Set()).add(system.name));
    }
  }
  const kinds = grouped(document.diagnostics, (diagnostic) => diagnostic.kind);
  const nothing = !ports.length && !missing.size && !kinds.size;
  return (
    <Section id="unknown" title="What is not known, and why">
      {nothing && <p class="muted">Everything that was read was understood.</p>}
      {missing.size > 0 && (
        <details open={missing.size <= MOST}>
          <summary>
            {counted(missing.size, "program")} that launch files start without a model: neither source nor library tells
            their ports
          </summary>
          <Table label="Programs without a model" head={["Program", "Started in"]}>
            {[...missing].map(([program, systems]) => (
              <tr key={program}>
                <td>
                  <Name text={program} />
                </td>
                <td>{systems.size === 1 ? <Name text={[...systems].join()} /> : counted(systems.size, "system")}</td>
              </tr>
            ))}
          </Table>
        </details>
      )}
      {ports.length > 0 && (
        <details open={ports.length <= MOST}>
          <summary>{counted(ports.length, "port")} whose name the source does not tell</summary>
          <Table label="Ports without a name" head={["Component", "Port", "Known of the name", "Why", "Source"]}>
            {ports.map(({ component, port }) => (
              <tr key={`${component.name} ${port.id}`}>
                <td>
                  <a href={componentHref(component.name)}>
                    <Name text={component.name} />
                  </a>
                </td>
                <td>{portLabel(port.kind)}</td>
                <td>
                  <code>{port.name}</code>
                </td>
                <td>{port.unknown}</td>
                <td>
                  <Source at={port.at} />
                </td>
              </tr>
            ))}
          </Table>
        </details>
      )}
      {[...kinds].sort().map(([kind, diagnostics]) => (
        <Diagnostics key={kind} kind={kind} diagnostics={diagnostics} />
      ))}
    </Section>
  );
}

function Diagnostics({ kind, diagnostics }: { kind: string; diagnostics: Diagnostic[] }) {
  return (
    <details>
      <summary>
        {counted(diagnostics.length, "diagnostic")}: {kind.replaceAll("-", " ")}
        <span class="muted">, such as “{shortened(diagnostics[0]?.message ?? "", 80)}”</span>
      </summary>
      <Table label={`Diagnostics: ${kind}`} head={["Message", "Place"]}>
        {diagnostics.map((diagnostic) => (
          <tr key={diagnostic.at + diagnostic.message}>
            <td>{diagnostic.message}</td>
            <td>
              <Source at={diagnostic.at} />
            </td>
          </tr>
        ))}
      </Table>
    </details>
  );
}
