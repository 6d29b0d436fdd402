/** The graph as SVG. What is lit or pale is told by classes, so that hovering draws nothing anew. */
import { memo } from "preact/compat";
import type { ConnectorKind } from "../data";
import type { Point, Rectangle } from "../elk";
import { SEVERITY_SIGNS } from "../parts/controls";
import { CONNECTOR_KINDS, SIGN_PATHS } from "../parts/kinds";
import { rounded } from "../parts/lines";
import type { Box, BoxPort, Frame, ShownConnector, ShownGraph } from "./build";
import type { Label } from "./labels";
import type { Drawing } from "./layout";
import { boxLines, connectorLines } from "./measure";

interface Props {
  graph: ShownGraph;
  drawing: Drawing;
  labels: readonly Label[];
  filtered: boolean;
  selected: string;
}

export const GraphDrawing = memo(({ graph, drawing, labels, filtered, selected }: Props) => (
  <>
    <defs>
      {CONNECTOR_KINDS.map((kind) => (
        <marker
          key={kind}
          id={`arrow-${kind}`}
          class={`kind-${kind}`}
          viewBox="0 0 8 8"
          refX="7.5"
          refY="4"
          markerWidth="7"
          markerHeight="7"
          orient="auto"
        >
          <path d="M0 0.5L8 4L0 7.5Z" />
        </marker>
      ))}
    </defs>
    <g>
      {[...graph.frames.values()].map((frame) => (
        <FrameShape key={frame.id} frame={frame} at={drawing.at.get(frame.id)} />
      ))}
    </g>
    <g class="links">
      {graph.links.map((link) => (
        <path
          key={link.id}
          class={`link kind-${link.kind} ${link.conditional ? "conditional" : ""}`}
          data-box={link.box}
          data-connector={link.connector}
          d={rounded(drawing.lines.get(link.id) ?? [])}
          marker-end={link.out ? undefined : `url(#arrow-${link.kind})`}
        />
      ))}
    </g>
    <g>
      {[...graph.connectors.values()].map((connector) => (
        <ConnectorShape
          key={connector.id}
          connector={connector}
          at={drawing.at.get(connector.id)}
          pale={filtered && !connector.matched}
          selected={selected === connector.id}
        />
      ))}
    </g>
    <g>
      {[...graph.boxes.values()].map((box) => (
        <BoxShape
          key={box.id}
          box={box}
          at={drawing.at.get(box.id)}
          ports={drawing.ports}
          pale={filtered && !box.matched}
          selected={selected === box.id}
        />
      ))}
    </g>
    <g class="names">
      {labels.map(({ id, of, text, x, y }) => (
        <text
          key={id}
          class={`name-${of} ${filtered && !isMatched(graph, id) ? "pale" : ""}`}
          data-name={id}
          x={x}
          y={y}
        >
          {text}
        </text>
      ))}
    </g>
  </>
));

const isMatched = ({ boxes, connectors }: ShownGraph, id: string): boolean =>
  (boxes.get(id) ?? connectors.get(id))?.matched ?? true;

function FrameShape({ frame, at }: { frame: Frame; at: Rectangle | undefined }) {
  if (!at) return null;
  return (
    <g class="frame" transform={`translate(${at.x} ${at.y})`}>
      <rect width={at.width} height={at.height} rx="8" />
      <g
        class="frame-title"
        data-group={frame.label}
        role="button"
        tabindex={0}
        aria-label={`Close the group ${frame.label}`}
      >
        <rect class="hit" width={Math.min(at.width, 24 + frame.label.length * 8)} height="26" />
        <path class="fold" d="M10 10h9l-4.500 6z" />
        <text x="25" y="17">
          {frame.label}
        </text>
      </g>
    </g>
  );
}

interface ShapeProps {
  at: Rectangle | undefined;
  pale: boolean;
  selected: boolean;
}

function BoxShape({ box, at, ports, pale, selected }: ShapeProps & { box: Box; ports: Map<string, Point> }) {
  if (!at) return null;
  const origin = box.nodes[0]?.origin ?? "unknown";
  const lines = boxLines(box);
  return (
    <g
      class={`box ${box.isGroup ? "group" : origin} ${pale ? "pale" : ""} ${selected ? "selected" : ""}`}
      data-id={box.id}
      role="button"
      tabindex={0}
      aria-label={`${box.isGroup ? "Group" : "Node"} ${box.label}`}
      aria-pressed={selected}
    >
      {box.isGroup && <rect class="behind" x={at.x + 4} y={at.y + 4} width={at.width} height={at.height} rx="6" />}
      <rect class="body" x={at.x} y={at.y} width={at.width} height={at.height} rx="6" />
      {lines.map(({ text, size }, number) => (
        <text
          key={`${number}`}
          class={number ? "detail" : "label"}
          x={at.x + at.width / 2}
          y={at.y + at.height / 2 + (number - (lines.length - 1) / 2) * 15 + size * 0.35}
        >
          {text}
        </text>
      ))}
      {box.severity && (
        <g class={`flag ${box.severity}`} transform={`translate(${at.x + at.width - 4} ${at.y + 3})`}>
          <circle r="7" />
          <text y="3.500">{SEVERITY_SIGNS[box.severity]}</text>
        </g>
      )}
      {box.ports.map((port) => (
        <PortShape key={port.id} port={port} at={ports.get(port.id)} />
      ))}
    </g>
  );
}

function PortShape({ port, at }: { port: BoxPort; at: Point | undefined }) {
  if (!at) return null;
  return (
    <path
      class={`port kind-${port.kind} ${port.out ? "" : "hollow"}`}
      transform={`translate(${at.x} ${at.y}) scale(4.2)`}
      d={SIGN_PATHS[port.kind]}
    />
  );
}

function ConnectorShape({ connector, at, pale, selected }: ShapeProps & { connector: ShownConnector }) {
  if (!at) return null;
  const lines = connectorLines(connector);
  return (
    <g
      class={`connector kind-${connector.kind} ${connector.oneSided ? "one-sided" : ""} ${pale ? "pale" : ""} ${selected ? "selected" : ""}`}
      data-id={connector.id}
      role="button"
      tabindex={0}
      aria-label={`${connector.kind} ${lines.join(", ")}`}
      aria-pressed={selected}
    >
      <path class="body" d={outline(connector.kind, at)} />
      {lines.map((text, number) => (
        <text
          key={`${number}`}
          x={at.x + at.width / 2}
          y={at.y + at.height / 2 + (number - (lines.length - 1) / 2) * 14 + 4}
        >
          {text}
        </text>
      ))}
    </g>
  );
}

/** Connectors differ in shape: topics are round, services six-sided, actions have double sides, transforms lean. */
function outline(kind: ConnectorKind, { x, y, width, height }: Rectangle): string {
  const [right, bottom, middle] = [x + width, y + height, y + height / 2];
  const round = Math.min(11, height / 2);
  switch (kind) {
    case "topic":
      return `M${x + round} ${y}H${right - round}A${round} ${round} 0 0 1 ${right} ${y + round}V${bottom - round}A${round} ${round} 0 0 1 ${right - round} ${bottom}H${x + round}A${round} ${round} 0 0 1 ${x} ${bottom - round}V${y + round}A${round} ${round} 0 0 1 ${x + round} ${y}Z`;
    case "service":
      return `M${x + 10} ${y}H${right - 10}L${right} ${middle}L${right - 10} ${bottom}H${x + 10}L${x} ${middle}Z`;
    case "action":
      return `M${x} ${y}H${right}V${bottom}H${x}ZM${x + 4} ${y}V${bottom}M${right - 4} ${y}V${bottom}`;
    case "tf":
      return `M${x + 10} ${y}H${right}L${right - 10} ${bottom}H${x}Z`;
  }
}
