/** The words and signs of ports and connectors. Signs differ in shape as well as in colour. */
import type { ConnectorKind } from "../data";

const LABELS: Record<string, string> = {
  publisher: "publisher",
  subscriber: "subscriber",
  service_server: "service server",
  service_client: "service client",
  action_server: "action server",
  action_client: "action client",
  tf_broadcaster: "tf broadcaster",
  tf_listener: "tf listener",
  dynamic_reconfigure_server: "reconfigure server",
};

export const CONNECTOR_KINDS: readonly ConnectorKind[] = ["topic", "service", "action", "tf"];

export const CONNECTOR_LABELS: Record<ConnectorKind, string> = {
  topic: "topics",
  service: "services",
  action: "actions",
  tf: "transforms",
};

export const portLabel = (kind: string): string => LABELS[kind] ?? kind.replaceAll("_", " ");

/** The kind of a component in words. */
export const componentKind = (kind: string): string => kind.replaceAll("_", " ");

export const portOrder = (kind: string): number => {
  const at = Object.keys(LABELS).indexOf(kind);
  return at < 0 ? Number.MAX_SAFE_INTEGER : at;
};

/** What kind of connector a port meets. */
function familyOf(kind: string): ConnectorKind {
  if (kind.startsWith("service") || kind.startsWith("dynamic")) return "service";
  if (kind.startsWith("action")) return "action";
  return kind.startsWith("tf") ? "tf" : "topic";
}

/** Whether messages, requests or goals leave the node through such a port. */
export const isOutgoing = (kind: string): boolean => /publisher|client|broadcaster/.test(kind);

/** The outlines of the signs, in a square from -1 to 1. */
export const SIGN_PATHS: Record<ConnectorKind, string> = {
  topic: "M0-.9A.9.9 0 1 1 0 .9A.9.9 0 1 1 0-.9Z",
  service: "M-1 0L-.5-.87L.5-.87L1 0L.5.87L-.5.87Z",
  action: "M-.85-.85H.85V.85H-.85Z",
  tf: "M0-1L1 0L0 1L-1 0Z",
};

export function Sign({ kind, hollow = false }: { kind: ConnectorKind; hollow?: boolean }) {
  return (
    <svg class={`sign kind-${kind} ${hollow ? "hollow" : ""}`} viewBox="-1.2 -1.2 2.4 2.4" aria-hidden="true">
      <path d={SIGN_PATHS[kind]} />
    </svg>
  );
}

export function PortKind({ kind }: { kind: string }) {
  return (
    <span class="port-kind">
      <Sign kind={familyOf(kind)} hollow={!isOutgoing(kind)} />
      {portLabel(kind)}
    </span>
  );
}
