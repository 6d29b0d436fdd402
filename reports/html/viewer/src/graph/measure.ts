/** The texts of boxes and connectors, and how wide they are. */
import { CONNECTOR_LABELS } from "../parts/kinds";
import { shortened } from "../parts/text";
import type { Box, ShownConnector } from "./build";

export const CONNECTOR_HEIGHT = 22;
const LONGEST = 44;
const MOST_NAMES = 2;

export interface BoxLine {
  text: string;
  size: number;
  weight: number;
}

export function boxLines(box: Box): BoxLine[] {
  return [
    { text: shortened(box.label, LONGEST), size: 13, weight: 600 },
    { text: shortened(box.detail, LONGEST), size: 11, weight: 400 },
  ];
}

export function connectorLines({ kind, connectors }: ShownConnector): string[] {
  const names = connectors.map(({ name }) => shortened(name, LONGEST));
  return names.length <= MOST_NAMES ? names : [`${names.length} ${CONNECTOR_LABELS[kind]}`];
}
