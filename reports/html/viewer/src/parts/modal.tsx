/** A dialog above the page; Escape, its button and a click beside it close it. */
import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

interface Props {
  open: boolean;
  label: string;
  title: string;
  onClose: () => void;
  children: ComponentChildren;
}

export function Modal({ open, label, title, onClose, children }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  const told = useRef(0); // closings whose event is to come, perhaps when the dialog is open again
  // before the next key can be pressed, which is for the dialog that is to be seen
  useLayoutEffect(() => {
    if (open) dialog.current?.showModal();
    else if (dialog.current?.open) {
      told.current++;
      dialog.current.close();
    }
  }, [open]);
  return (
    <dialog
      ref={dialog}
      class="modal"
      aria-label={label}
      onClose={() => (told.current ? told.current-- : onClose())}
      onClick={(event) => event.target === dialog.current && onClose()}
    >
      {open && (
        <>
          <header>
            <code class="path">{title}</code>
            <button type="button" class="quiet" onClick={onClose} aria-label="Close">
              ✕
            </button>
          </header>
          {children}
        </>
      )}
    </dialog>
  );
}
