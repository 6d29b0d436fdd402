/** Proofs: the rules and facts that something rests on, as trees. */
import { useEffect, useState } from "preact/hooks";
import { type Proven, type Subject, useShared } from "../context";
import { type Proofs, type Rate, type ReportDocument, type System, type SystemNode, unpack } from "../data";
import { Modal } from "./modal";
import { Source } from "./source";
import { shortened } from "./text";

let unpacked: Promise<Proofs | null> | null = null;

function proofsOf(document: ReportDocument): Promise<Proofs | null> {
  if (document.proofs) return Promise.resolve(document.proofs);
  unpacked ??= unpack("proofs").then((text) => (text ? (JSON.parse(text) as Proofs) : null));
  return unpacked;
}

interface Props {
  owner: string;
  of: string | string[];
  title: string;
  /** Proofs of others that tell more. */
  more?: Proven[];
}

/** A button that shows why something is as it is. */
export function Why({ owner, of, title, more = [] }: Props) {
  const { showProof } = useShared();
  const proofs = [of].flat().map((key) => ({ owner, key }));
  return (
    <button
      type="button"
      class="why"
      aria-label={`Why: ${shortened(title, 80)}`}
      title="The rules and facts that tell this"
      onClick={() => showProof({ title, proofs: [...proofs, ...more] })}
    >
      why
    </button>
  );
}

/** Why something is sent so often on a topic, or why that is not known. */
export function WhyRate({ system, rate: { topic, reasons } }: { system: System; rate: Rate }) {
  const unknown = reasons.map((reason) => `topic_unbounded ${topic} ${reason}`);
  const of = [`topic_high ${topic}`, `topic_low ${topic}`, ...unknown];
  return <Why owner={system.name} of={of} title={`messages a second on ${topic}`} />;
}

/** What in the launch files starts a node, and what they give to it. */
export function WhyStarted({ system, node }: { system: System; node: SystemNode }) {
  return <Why owner={system.name} of={`node ${node.id}`} title={`${node.name} is started`} />;
}

export function ProofDialog({ subject, onClose }: { subject: Subject | null; onClose: () => void }) {
  return (
    <Modal open={subject !== null} label="Why" title={subject ? shortened(subject.title, 120) : ""} onClose={onClose}>
      {subject && (
        <div class="proof-body">
          <ProofTrees of={subject.proofs} />
        </div>
      )}
    </Modal>
  );
}

export function ProofTrees({ of }: { of: Proven[] }) {
  const { report } = useShared();
  const [proofs, setProofs] = useState<Proofs | null | undefined>();
  useEffect(() => {
    let wanted = true;
    proofsOf(report.document).then((all) => wanted && setProofs(all));
    return () => {
      wanted = false;
    };
  }, [report]);
  if (proofs === undefined) return <p class="muted">Reading the proofs …</p>;
  const found = of.flatMap(({ owner, key }) => {
    const root = proofs?.roots?.[owner]?.[key];
    return root !== undefined ? [{ key, root }] : [];
  });
  if (!proofs || !found.length)
    return <p class="muted">The report has no proof of this; it may be made without proofs.</p>;
  return (
    <ul class="proof-tree">
      {found.map(({ key, root }) => (
        <Step key={key} proofs={proofs} number={root} depth={0} />
      ))}
    </ul>
  );
}

/** Steps that tell by themselves what they are. */
const PLAIN = new Set(["condition", "launch file"]);
const OPEN = 1; // levels that are open at first

function Step({ proofs, number, depth }: { proofs: Proofs; number: number; depth: number }) {
  const [open, setOpen] = useState(depth < OPEN);
  const step = proofs.steps[number];
  if (!step) return null;
  const [text, rule, premises, cut, place] = step;
  const line = (
    <>
      <code>{shortened(text, 400)}</code> <span class="muted">{PLAIN.has(rule) ? "" : rule}</span>{" "}
      {place !== undefined && <Source at={proofs.places[place]} />}
    </>
  );
  if (!premises.length) {
    return (
      <li class="leaf">
        {line}
        {cut === 1 && <span class="muted"> …</span>}
      </li>
    );
  }
  return (
    <li>
      <details class="proof" open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
        <summary>{line}</summary>
        {open && (
          <ul class="proof-tree">
            {premises.map((premise, at) => (
              <Step key={`${at}`} proofs={proofs} number={premise} depth={depth + 1} />
            ))}
          </ul>
        )}
      </details>
    </li>
  );
}
