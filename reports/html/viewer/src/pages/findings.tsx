/** Findings, each with the chain of source lines that make it a fault. */
import { useState } from "preact/hooks";
import { useReport } from "../context";
import type { Evidence, Finding, Severity } from "../data";
import { bySeverity, counted, countedOf, SEVERITIES } from "../model";
import { Filter, matches, SeverityBadge, Toggle } from "../parts/controls";
import { ProofTrees } from "../parts/proof";
import { Excerpt, Source } from "../parts/source";
import { ending, Name, shortened } from "../parts/text";
import { type Route, setParams } from "../route";

const PAGE = 200;

export function FindingsPage({ route }: { route: Route }) {
  const { document } = useReport();
  const { shown, suppressed, checks } = document.findings;
  const { params } = route;
  const chosen = new Set((params.get("severity") ?? SEVERITIES.join(",")).split(","));
  const filter = params.get("filter") ?? "";
  const check = params.get("check") ?? "";
  const system = params.get("system") ?? "";
  const [most, setMost] = useState(PAGE);
  const found = shown
    .filter((finding) => chosen.has(finding.severity) && (!check || finding.check === check))
    .filter((finding) => !system || finding.systems.includes(system))
    .filter((finding) => matches(filter, finding.check, finding.message, ...finding.evidence.map((step) => step.at)))
    .sort(bySeverity);
  const toggle = (severity: Severity) => {
    const next = SEVERITIES.filter((each) => (each === severity) !== chosen.has(each));
    setParams({ severity: next.length === SEVERITIES.length ? null : next.join(",") || "none" });
  };
  const names = [...new Set(shown.map((finding) => finding.check))].sort();
  return (
    <>
      <h1>Findings</h1>
      <div class="controls">
        <Filter label="Filter by text, name, path" param="filter" value={filter} />
        {SEVERITIES.map((severity) => (
          <Toggle key={severity} pressed={chosen.has(severity)} onToggle={() => toggle(severity)}>
            {severity}s <span class="count">{shown.filter((finding) => finding.severity === severity).length}</span>
          </Toggle>
        ))}
        <select aria-label="Check" value={check} onChange={(event) => setParams({ check: event.currentTarget.value })}>
          <option value="">all checks</option>
          {names.map((name) => (
            <option key={name}>{name}</option>
          ))}
        </select>
        {document.systems.length > 1 && (
          <select
            aria-label="System"
            value={system}
            onChange={(event) => setParams({ system: event.currentTarget.value })}
          >
            <option value="">all systems</option>
            {document.systems.map(({ name }) => (
              <option key={name} value={name}>
                {ending(name, 60)}
              </option>
            ))}
          </select>
        )}
      </div>
      {check && checks[check] && <p class="lead">{checks[check].description}</p>}
      <p class="muted" aria-live="polite">
        {countedOf(found.length, shown.length, "finding")}
      </p>
      {found.slice(0, most).map((finding) => (
        <FindingCard key={finding.id} finding={finding} />
      ))}
      {found.length > most && (
        <button type="button" onClick={() => setMost(most + PAGE)}>
          Show {Math.min(PAGE, found.length - most)} more
        </button>
      )}
      {suppressed.length > 0 && (
        <section aria-labelledby="suppressed">
          <h2 id="suppressed">
            Suppressed by comments <span class="count">{suppressed.length}</span>
          </h2>
          {suppressed.map((finding) => (
            <FindingCard key={finding.id} finding={finding} />
          ))}
        </section>
      )}
    </>
  );
}

export function FindingCard({ finding }: { finding: Finding }) {
  const [open, setOpen] = useState(false);
  return (
    <details class={`finding ${finding.severity}`} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>
        <SeverityBadge severity={finding.severity} />
        <span class="message">{shortened(finding.message, 600)}</span>
        <span class="meta">
          <span class="check">{finding.check}</span>
        </span>
      </summary>
      {open && <FindingBody finding={finding} />}
    </details>
  );
}

function FindingBody({ finding }: { finding: Finding }) {
  const { document } = useReport();
  const check = document.findings.checks[finding.check];
  return (
    <div class="body">
      {finding.reason !== undefined && <p>Suppressed: {finding.reason || "no reason is given"}</p>}
      <ol class="evidence">
        {finding.evidence.map((step, at) => (
          <Step key={`${step.at} ${step.text}`} step={step} main={at === 0} />
        ))}
      </ol>
      {check && (
        <>
          <p class="hint">
            <strong>What to do</strong> {check.recommendation}
          </p>
          <details class="about">
            <summary>About {check.title.charAt(0).toLowerCase() + check.title.slice(1)}</summary>
            <p>{check.description}</p>
            {check.scenario && (
              <pre class="excerpt" tabIndex={0}>
                {check.scenario}
              </pre>
            )}
          </details>
        </>
      )}
      {finding.systems[0] !== undefined && <Derivation finding={finding} system={finding.systems[0]} />}
      {finding.systems.length > 0 && (
        <p class="muted">
          In{" "}
          {finding.systems.slice(0, 8).map((name, at) => (
            <span key={name}>
              {at > 0 && ", "}
              <Name text={name} />
            </span>
          ))}
          {finding.systems.length > 8 && ` and ${counted(finding.systems.length - 8, "other system")}`}
        </p>
      )}
    </div>
  );
}

function Derivation({ finding, system }: { finding: Finding; system: string }) {
  const [open, setOpen] = useState(false);
  return (
    <details class="about proof" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>The rules and facts that tell this</summary>
      {open && <ProofTrees of={[{ owner: system, key: `finding ${finding.id}` }]} />}
    </details>
  );
}

function Step({ step, main }: { step: Evidence; main: boolean }) {
  return (
    <li>
      <div>
        {!(main && !step.text) && <span>{shortened(step.text, 400)} </span>}
        <Source at={step.at} full />
      </div>
      <Excerpt at={step.at} mark={step.mark} around={main ? 2 : 1} />
    </li>
  );
}
