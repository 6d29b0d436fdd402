/** What all parts of the page share. */
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { Place } from "./data";
import type { Report } from "./model";

/** What is proven: the component or system that has it, and the key of the thing there. */
export interface Proven {
  owner: string;
  key: string;
}

/** What a dialog of proofs is about. */
export interface Subject {
  title: string;
  proofs: Proven[];
}

export interface Shared {
  report: Report;
  showSource: (place: Place) => void;
  showProof: (subject: Subject) => void;
}

export const SharedContext = createContext<Shared | null>(null);

export function useShared(): Shared {
  const shared = useContext(SharedContext);
  if (!shared) throw new Error("outside of the page");
  return shared;
}

export const useReport = (): Report => useShared().report;
