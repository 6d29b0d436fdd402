/** The controls of the graph. Each choice is kept in the address. */
import { useEffect, useRef } from "preact/hooks";
import type { System } from "../data";
import { Filter, Toggle } from "../parts/controls";
import { CONNECTOR_KINDS, CONNECTOR_LABELS, Sign } from "../parts/kinds";
import { SystemChoice } from "../parts/system";
import { shortened } from "../parts/text";
import { setParams } from "../route";
import type { Camera } from "./camera";
import { type GraphOptions, toggledKinds } from "./options";

/** What is chosen less often. */
function View({ options }: { options: GraphOptions }) {
  const box = (name: string, on: boolean, inverse: boolean, text: string) => (
    <label>
      <input type="checkbox" checked={on} onChange={() => setParams({ [name]: on === inverse ? "1" : null })} />
      {text}
    </label>
  );
  const menu = useRef<HTMLDetailsElement>(null);
  const close = () => {
    if (menu.current) menu.current.open = false;
  };
  useEffect(() => {
    const outside = (event: PointerEvent) =>
      event.target instanceof Node && !menu.current?.contains(event.target) && close();
    addEventListener("pointerdown", outside);
    return () => removeEventListener("pointerdown", outside);
  }, []);
  return (
    <details
      class="menu"
      ref={menu}
      onKeyDown={(event) => event.key === "Escape" && close()}
      onFocusOut={(event) =>
        event.relatedTarget instanceof Node && !menu.current?.contains(event.relatedTarget) && close()
      }
    >
      <summary>View</summary>
      <div>
        <label>
          Group nodes
          <select
            aria-label="Group nodes by"
            value={options.grouping}
            onChange={(event) => setParams({ by: event.currentTarget.value, groups: null })}
          >
            <option value="namespace">by namespace</option>
            <option value="package">by package</option>
            <option value="none">not at all</option>
          </select>
        </label>
        <label>
          <input
            type="checkbox"
            checked={options.bundled}
            onChange={() => setParams({ bundle: options.bundled ? "0" : "1" })}
          />
          Connectors between the same nodes as one
        </label>
        {box("findings", options.findings, false, "Only nodes with findings")}
        {box("joined", options.oneSided, true, "Connectors with a sender or a receiver only")}
        {box("implicit", options.implicit, false, "Connectors that only libraries make")}
      </div>
    </details>
  );
}

interface Props {
  system: System;
  options: GraphOptions;
  camera: { current: Camera | null };
}

export function Toolbar({ system, options, camera }: Props) {
  const flag = (name: string, on: boolean) => () => setParams({ [name]: on ? null : "1" });
  return (
    <div class="controls toolbar">
      <SystemChoice system={system} />
      <Filter label="Find name, type, package" param="filter" value={options.filter} />
      {options.filter && (
        <Toggle pressed={options.only} onToggle={flag("only", options.only)} title="Leave out what does not match">
          only these
        </Toggle>
      )}
      <span class="joined" role="group" aria-label="Kinds of connectors">
        {CONNECTOR_KINDS.map((kind) => (
          <Toggle
            key={kind}
            pressed={options.kinds.has(kind)}
            onToggle={() => setParams({ kinds: toggledKinds(options, kind) })}
          >
            <Sign kind={kind} /> {CONNECTOR_LABELS[kind]}
          </Toggle>
        ))}
      </span>
      <View options={options} />
      {options.focus && (
        <span class="focus">
          near <strong>{shortened(options.focus, 40)}</strong>
          <select
            aria-label="How many connectors away"
            value={options.hops}
            onChange={(event) => setParams({ hops: event.currentTarget.value })}
          >
            {[1, 2, 3, 4].map((hops) => (
              <option key={hops} value={hops}>
                {hops === 1 ? "1 step" : `${hops} steps`}
              </option>
            ))}
          </select>
          <button type="button" onClick={() => setParams({ focus: null, hops: null })}>
            Show all
          </button>
        </span>
      )}
      {options.from && options.to && (
        <span class="focus">
          chain lit
          <button type="button" onClick={() => setParams({ from: null, to: null })}>
            Clear
          </button>
        </span>
      )}
      <span class="joined zoom" role="group" aria-label="Zoom">
        <button type="button" onClick={() => camera.current?.zoom(0.8)} aria-label="Zoom out">
          −
        </button>
        <button type="button" onClick={() => camera.current?.fit()}>
          Fit
        </button>
        <button type="button" onClick={() => camera.current?.zoom(1.25)} aria-label="Zoom in">
          +
        </button>
      </span>
    </div>
  );
}
