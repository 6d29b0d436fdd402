/** Controls that pages share. */
import type { ComponentChildren } from "preact";
import type { Severity } from "../data";
import { setParams } from "../route";

interface FilterProps {
  label: string;
  param: string;
  value: string;
}

/** A field whose text is kept in the address. */
export function Filter({ label, param, value }: FilterProps) {
  return (
    <input
      type="search"
      class="filter"
      aria-label={label}
      placeholder={label}
      value={value}
      onInput={(event) => setParams({ [param]: event.currentTarget.value })}
    />
  );
}

interface ToggleProps {
  pressed: boolean;
  onToggle: () => void;
  children: ComponentChildren;
  title?: string;
}

export function Toggle({ pressed, onToggle, children, title }: ToggleProps) {
  return (
    <button type="button" class="toggle" aria-pressed={pressed} onClick={onToggle} title={title}>
      {children}
    </button>
  );
}

export const SEVERITY_SIGNS: Record<Severity, string> = { error: "✕", warning: "!", note: "i" };

export function SeverityBadge({ severity, count }: { severity: Severity; count?: number }) {
  return (
    <span class={`badge ${severity}`}>
      <span class="badge-sign" aria-hidden="true">
        {SEVERITY_SIGNS[severity]}
      </span>
      {count === undefined ? severity : `${count.toLocaleString("en")} ${severity}${count === 1 ? "" : "s"}`}
    </span>
  );
}

/** A table that can be scrolled sideways where it is wider than the page. */
export function Table({
  head,
  children,
  label,
}: {
  head: readonly string[];
  children: ComponentChildren;
  label: string;
}) {
  return (
    <div class="table" role="region" aria-label={label} tabIndex={0}>
      <table>
        <thead>
          <tr>
            {head.map((text) => (
              <th key={text} scope="col">
                {text}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>{children}</tbody>
      </table>
    </div>
  );
}

export function Section({
  id,
  title,
  count,
  children,
}: {
  id: string;
  title: string;
  count?: number;
  children: ComponentChildren;
}) {
  return (
    <section id={id} aria-labelledby={`${id}-title`}>
      <h2 id={`${id}-title`}>
        {title} {count !== undefined && <span class="count">{count.toLocaleString("en")}</span>}
      </h2>
      {children}
    </section>
  );
}

/** Whether a text has all words of a filter, in any order. */
export function matches(filter: string, ...texts: (string | null | undefined)[]): boolean {
  const all = texts.filter(Boolean).join(" ").toLowerCase();
  return filter
    .toLowerCase()
    .split(/\s+/)
    .every((word) => all.includes(word));
}
