/** Proofs: the rules and facts that something rests on, as trees. */
import { useEffect, useState } from "preact/hooks";
import { useShared } from "../context";
import { type Proofs, type ReportDocument, unpack } from "../data";
import { Modal } from "./modal";
import { shortened } from "./text";

/** What a proof is of: the component or system, and the key of the thing there. */
export interface Subject {
  owner: string;
  key: string;
  title: string;
}

let unpacked: Promise<Record<string, Proofs>> | null = null;

function proofsOf(document: ReportDocument): Promise<Record<string, Proofs>> {
  if (document.proofs) return Promise.resolve(document.proofs);
  unpacked ??= unpack("proofs").then((text) => (text ? JSON.parse(text) : {}));
  return unpacked;
}

/** A button that shows why something is as it is. */
export function Why({ owner, of, title }: { owner: string; of: string; title: string }) {
  const { showProof } = useShared();
  return (
    <button
      type="button"
      class="why"
      aria-label={`Why: ${shortened(title, 80)}`}
      title="The rules and facts that tell this"
      onClick={() => showProof({ owner, key: of, title })}
    >
      why
    </button>
  );
}

export function ProofDialog({ subject, onClose }: { subject: Subject | null; onClose: () => void }) {
  return (
    <Modal open={subject !== null} label="Why" title={subject ? shortened(subject.title, 120) : ""} onClose={onClose}>
      {subject && (
        <div class="proof-body">
          <ProofTree owner={subject.owner} of={subject.key} />
        </div>
      )}
    </Modal>
  );
}

export function ProofTree({ owner, of }: { owner: string; of: string }) {
  const { report } = useShared();
  const [proofs, setProofs] = useState<Proofs | null | undefined>();
  useEffect(() => {
    let wanted = true;
    proofsOf(report.document).then((all) => wanted && setProofs(all[owner] ?? null));
    return () => {
      wanted = false;
    };
  }, [report, owner]);
  if (proofs === undefined) return <p class="muted">Reading the proofs …</p>;
  const root = proofs?.roots[of];
  if (!proofs || root === undefined)
    return <p class="muted">The report has no proof of this; it may be made without proofs.</p>;
  return (
    <ul class="proof-tree">
      <Step proofs={proofs} number={root} depth={0} />
    </ul>
  );
}

const OPEN = 1; // levels that are open at first

function Step({ proofs, number, depth }: { proofs: Proofs; number: number; depth: number }) {
  const [open, setOpen] = useState(depth < OPEN);
  const step = proofs.steps[number];
  if (!step) return null;
  const [text, rule, premises, cut] = step;
  const line = (
    <>
      <code>{shortened(text, 400)}</code> <span class="muted">{rule === "condition" ? "" : rule}</span>
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
