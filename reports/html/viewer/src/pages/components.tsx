/** All components, with what each has. */

import { useReport } from "../context";
import type { Component } from "../data";
import { countedOf } from "../model";
import { Filter, matches, SeverityBadge, Table } from "../parts/controls";
import { componentKind } from "../parts/kinds";
import { Maybe, Name } from "../parts/text";
import { componentHref, type Route } from "../route";

export function ComponentsPage({ route }: { route: Route }) {
  const { document } = useReport();
  const filter = route.params.get("filter") ?? "";
  const shown = document.components.filter((component) =>
    matches(
      filter,
      component.name,
      component.node_name,
      componentKind(component.kind),
      component.middleware,
      component.executable,
      component.plugin?.name,
      ...component.ports.flatMap((port) => [port.name, port.type]),
    ),
  );
  return (
    <>
      <h1>Components</h1>
      <div class="controls">
        <Filter label="Filter by name, port, type" param="filter" value={filter} />
        <span class="muted" aria-live="polite">
          {countedOf(shown.length, document.components.length, "component")}
        </span>
      </div>
      <Table
        label="Components"
        head={[
          "Component",
          "Kind",
          "Middleware",
          "Sends",
          "Receives",
          "Serves",
          "Calls",
          "Parameters",
          "States",
          "Started",
          "Findings",
        ]}
      >
        {shown.map((component) => (
          <Row key={component.name} component={component} />
        ))}
      </Table>
    </>
  );
}

function Row({ component }: { component: Component }) {
  const report = useReport();
  const ports = component.ports.filter((port) => !port.implicit);
  const number = (pattern: RegExp) => ports.filter((port) => pattern.test(port.kind)).length;
  const states = component.machine.regions.reduce((sum, region) => sum + region.states.length, 0);
  const findings = report.findingsOf(component);
  return (
    <tr>
      <td>
        <a href={componentHref(component.name)}>
          <Name text={component.name} />
        </a>
        {component.executable && <div class="muted">of {component.executable}</div>}
      </td>
      <td class="whole">{componentKind(component.kind)}</td>
      <td class="whole">
        <Maybe text={component.middleware} />
      </td>
      <Count value={number(/publisher|broadcaster/)} />
      <Count value={number(/subscriber|listener/)} />
      <Count value={number(/server/)} />
      <Count value={number(/client/)} />
      <Count value={new Set(component.params.map((parameter) => parameter.name)).size} />
      <Count value={states} />
      <Count value={report.instances.get(component.name)?.length ?? 0} />
      <td class="number">
        {findings[0] ? (
          <SeverityBadge severity={findings[0].severity} count={findings.length} />
        ) : (
          <span class="none">–</span>
        )}
      </td>
    </tr>
  );
}

function Count({ value }: { value: number }) {
  return <td class="number">{value || <span class="none">–</span>}</td>;
}
