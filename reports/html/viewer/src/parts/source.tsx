/** Places in the source: links that show the lines, from the excerpts that the report brings with it. */
import { useShared } from "../context";
import type { Place, ReportDocument, Run } from "../data";
import { Modal } from "./modal";
import { shortened } from "./text";

export function splitPlace(place: Place): [string, number] {
  const at = place.lastIndexOf(":");
  return [place.slice(0, at), Number(place.slice(at + 1))];
}

/** The address of a place on a forge, when the report was told one. */
function forgeLink(document: ReportDocument, place: Place): string | undefined {
  const [path, line] = splitPlace(place);
  const encoded = path.split("/").map(encodeURIComponent).join("/");
  return document.link?.replaceAll("{path}", () => encoded).replaceAll("{line}", String(line));
}

export function Source({ at, full = false }: { at: Place | null | undefined; full?: boolean }) {
  const { report, showSource } = useShared();
  if (!at) return <span class="none">–</span>;
  const [path, line] = splitPlace(at);
  const text = full ? at : `${path.slice(path.lastIndexOf("/") + 1)}:${line}`;
  const link = forgeLink(report.document, at);
  const show = (event: MouseEvent) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    showSource(at);
  };
  const title = full ? undefined : at;
  return link ? (
    <a class="place" href={link} target="_blank" rel="noopener noreferrer" title={title} onClick={show}>
      {shortened(text, 120)}
    </a>
  ) : (
    <button type="button" class="place" title={title} onClick={show}>
      {shortened(text, 120)}
    </button>
  );
}

export function Sources({ at }: { at: readonly Place[] }) {
  return (
    <span class="places">
      {[...new Set(at)].map((place) => (
        <Source key={place} at={place} />
      ))}
    </span>
  );
}

interface ExcerptProps {
  at: Place;
  mark?: [number, number] | null;
  around?: number;
}

/** The line of a place with some around it. */
export function Excerpt({ at, mark = null, around = 1 }: ExcerptProps) {
  const { report } = useShared();
  const [path, line] = splitPlace(at);
  const lines = linesAround(report.document.sources[path] ?? [], line, around);
  if (!lines.length) return null;
  return (
    <pre class="excerpt" tabIndex={0} role="region" aria-label={`Source ${shortened(at, 80)}`}>
      {lines.map(([number, text]) => (
        <span key={number} class={number === line ? "line meant" : "line"}>
          <span class="number">{number}</span>
          <span class="text">{number === line && mark ? marked(text, mark) : text || " "}</span>
        </span>
      ))}
    </pre>
  );
}

function marked(text: string, [from, to]: [number, number]) {
  return (
    <>
      {text.slice(0, from)}
      <mark>{text.slice(from, to)}</mark>
      {text.slice(to)}
    </>
  );
}

function linesAround(runs: readonly Run[], line: number, around: number): [number, string][] {
  for (const [first, texts] of runs) {
    if (line >= first && line < first + texts.length) {
      return texts
        .map((text, at): [number, string] => [first + at, text])
        .filter(([number]) => Math.abs(number - line) <= around);
    }
  }
  return [];
}

/** A dialog with the lines around a place; `null` closes it. */
export function SourceDialog({ at, onClose }: { at: Place | null; onClose: () => void }) {
  const { report } = useShared();
  const link = at ? forgeLink(report.document, at) : undefined;
  const readable = at && report.document.sources[splitPlace(at)[0]];
  return (
    <Modal open={at !== null} label="Source" title={at ? shortened(at, 200) : ""} onClose={onClose}>
      {at && readable ? (
        <Excerpt at={at} around={8} />
      ) : (
        <p class="muted">This file could not be read when the report was made.</p>
      )}
      <footer>
        {link && (
          <a href={link} target="_blank" rel="noopener noreferrer">
            Open in the repository
          </a>
        )}
        <button type="button" class="quiet" onClick={() => at && navigator.clipboard?.writeText(at)}>
          Copy path
        </button>
      </footer>
    </Modal>
  );
}
