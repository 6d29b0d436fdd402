/** Texts of the input: names of any length, code, types. */

const LONGEST = 120;

/** A name; the middle of a very long one is left out, its title has all of it. */
export function Name({ text, strong = false }: { text: string; strong?: boolean }) {
  const shown = shortened(text, LONGEST);
  return (
    <span class={strong ? "name strong" : "name"} title={shown === text ? undefined : text}>
      {breakable(shown)}
    </span>
  );
}

export function shortened(text: string, most: number): string {
  if (text.length <= most) return text;
  const head = Math.ceil((most - 1) * 0.6);
  return `${text.slice(0, head)}…${text.slice(text.length - (most - 1 - head))}`;
}

/** The end of a text, which of paths is what tells them apart. */
export const ending = (text: string, most: number): string =>
  text.length <= most ? text : `…${text.slice(text.length - most + 1)}`;

/** The parts of a name, with places between them where a line may be broken. */
function breakable(text: string) {
  const parts = text.split(/(?<=[_:.])|(?=\/)/);
  return parts.length > 40 ? text : parts.flatMap((part, at) => (at ? [<wbr key={`b${at}`} />, part] : [part]));
}

export function Maybe({ text }: { text: string | number | boolean | null | undefined }) {
  return text === null || text === undefined || text === "" ? <span class="none">–</span> : <span>{String(text)}</span>;
}

/** A condition in the source's words. */
export function Condition({ text }: { text: string | null | undefined }) {
  return text ? <code class="condition">{shortened(text, 400)}</code> : <span class="none">–</span>;
}
