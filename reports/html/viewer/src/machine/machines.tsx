/** The state machines of a component: a diagram and a table for each. */
import { useEffect, useState } from "preact/hooks";
import { useShared } from "../context";
import type { Effect, Machine, Region } from "../data";
import { Section, Table } from "../parts/controls";
import { rounded } from "../parts/lines";
import { Why } from "../parts/proof";
import { Sources } from "../parts/source";
import { Condition, Maybe, Name, shortened } from "../parts/text";
import {
  LINE,
  layOutMachine,
  type MachineDrawing,
  type StateShape,
  type TextLine,
  TITLE,
  type TransitionShape,
} from "./layout";

export function Machines({ owner, machine }: { owner: string; machine: Machine }) {
  const { regions, always, left_out, dead, messages } = machine;
  if (!regions.length && !left_out.length && !messages.length) return null;
  return (
    <Section id="machines" title="State machines" count={regions.length}>
      {regions.map((region) => (
        <RegionView key={region.title} owner={owner} region={region} />
      ))}
      {always.length > 0 && (
        <>
          <h3>In every state</h3>
          <ul class="plain">
            {always.map((text) => (
              <li key={text}>{shortened(text, 300)}</li>
            ))}
          </ul>
        </>
      )}
      {left_out.length > 0 && (
        <p class="muted">
          Not shown, as their values are too many to tell apart:{" "}
          {left_out.map((text) => shortened(text, 80)).join(", ")}
        </p>
      )}
      {dead.length > 0 && (
        <p class="muted">
          What no state that can be reached lets happen: <Sources at={dead.flatMap(({ at }) => at)} />
        </p>
      )}
      {messages.map((text) => (
        <p key={text} class="muted">
          {text}
        </p>
      ))}
    </Section>
  );
}

function RegionView({ owner, region }: { owner: string; region: Region }) {
  const [drawing, setDrawing] = useState<MachineDrawing | null>(null);
  useEffect(() => {
    let wanted = true;
    layOutMachine(region).then(
      (found) => wanted && setDrawing(found),
      () => undefined, // the table tells the same
    );
    return () => {
      wanted = false;
    };
  }, [region]);
  return (
    <div class="region">
      <h3>
        <Name text={region.title} />
      </h3>
      <div
        class="diagram"
        role="region"
        aria-label={`Diagram of ${shortened(region.title, 80)}`}
        tabIndex={0}
        aria-busy={!drawing}
      >
        {drawing ? <Diagram drawing={drawing} title={region.title} /> : <p class="muted">Laying out …</p>}
      </div>
      {region.never.length > 0 && (
        <p class="muted">Never: {region.never.map((text) => shortened(text, 120)).join("; ")}</p>
      )}
      <details>
        <summary>Transitions as a table</summary>
        <Table
          label={`Transitions of ${shortened(region.title, 80)}`}
          head={["In", "On", "If", "Sends", "Then", "Source"]}
        >
          {region.arcs.map((arc, at) => (
            <tr key={`${at}`}>
              <td>{shortened(arc.from, 200)}</td>
              <td>{shortened(arc.on, 200)}</td>
              <td>
                <Condition text={arc.if} />
              </td>
              <td>
                <Maybe text={shortened(arc.sends, 300)} />
              </td>
              <td>{arc.to ? <Name text={arc.to} strong /> : <span class="none">stays</span>}</td>
              <td>
                <Sources at={arc.at} />
                {arc.to && <Why owner={owner} of={`transition ${arc.at[0]}`} title={`${arc.on} → ${arc.to}`} />}
              </td>
            </tr>
          ))}
        </Table>
      </details>
    </div>
  );
}

function Diagram({ drawing, title }: { drawing: MachineDrawing; title: string }) {
  return (
    <svg
      class="machine"
      width={drawing.width}
      height={drawing.height}
      viewBox={`0 0 ${drawing.width} ${drawing.height}`}
      role="group"
      aria-label={`States of ${shortened(title, 80)}`}
    >
      <defs>
        <marker id="arrow-state" viewBox="0 0 8 8" refX="7.5" refY="4" markerWidth="8" markerHeight="8" orient="auto">
          <path d="M0 0.5L8 4L0 7.5Z" />
        </marker>
      </defs>
      {drawing.starts.map((points, at) => (
        <g key={`${at}`} class="start">
          {points[0] && <circle cx={points[0].x} cy={points[0].y - 5} r="6" />}
          <path class="arrow" d={rounded(points)} marker-end="url(#arrow-state)" />
        </g>
      ))}
      {drawing.transitions.map(({ id, points }) => (
        <path key={id} class="arrow" d={rounded(points)} marker-end="url(#arrow-state)" />
      ))}
      {drawing.states.map((state) => (
        <State key={state.id} state={state} />
      ))}
      {drawing.transitions.map((transition) => (
        <TransitionLabel key={transition.id} transition={transition} />
      ))}
    </svg>
  );
}

function State({ state: { at, kind, title, inner, inside } }: { state: StateShape }) {
  return (
    <g class={`state ${kind}`}>
      <rect x={at.x} y={at.y} width={at.width} height={at.height} rx="10" />
      <text class="title" x={at.x + at.width / 2} y={at.y + 20}>
        {shortened(title, 60)}
        {kind === "unreachable" && <title>{title} cannot be reached</title>}
      </text>
      {inner.length > 0 && <path class="rule" d={`M${at.x} ${at.y + TITLE}h${at.width}`} />}
      <Effects texts={inner} effects={inside} x={at.x + 12} y={at.y + TITLE + 4} />
    </g>
  );
}

function TransitionLabel({ transition: { label, texts, effects } }: { transition: TransitionShape }) {
  return (
    <g class="transition">
      <rect x={label.x} y={label.y} width={label.width} height={label.height} rx="3" />
      <Effects texts={texts} effects={effects} x={label.x + 6} y={label.y} />
    </g>
  );
}

/** Effects below each other; each leads to its source. */
function Effects({ texts, effects, x, y }: { texts: TextLine[][]; effects: Effect[]; x: number; y: number }) {
  const { showSource } = useShared();
  let below = y;
  return (
    <>
      {texts.map((lines, number) => {
        const top = below;
        below += lines.length * LINE + 4;
        const place = effects[number]?.at[0];
        const leads = place
          ? action(`${lines.map(({ text }) => text).join(" ")}, show source`, () => showSource(place))
          : {};
        return (
          <g key={`${number}`} class="effect" {...leads}>
            {place && <title>{effects[number]?.at.join("\n")}</title>}
            {lines.map(({ kind, text }, line) => (
              <text key={`${line}`} class={kind} x={x} y={top + (line + 1) * LINE - 3}>
                {text}
              </text>
            ))}
          </g>
        );
      })}
    </>
  );
}

/** What makes a part of a drawing a button. */
function action(label: string, act: () => void) {
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    act();
  };
  return { role: "button" as const, tabindex: 0, "aria-label": label, onClick: act, onKeyDown };
}
