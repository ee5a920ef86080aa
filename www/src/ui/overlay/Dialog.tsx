import "./overlay.css";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { IconButton } from "../controls/Button";
import { useOwnId } from "../id";
import css from "./overlay.module.css";

interface DialogProps {
  title: string;
  /** One quiet sentence under the title. */
  about?: string;
  onClose: () => void;
  children: ComponentChildren;
  wide?: boolean;
  /** Nothing in it takes the focus, so its text does: keys can then scroll it. */
  reading?: boolean;
}

/** A native modal dialog: it holds the focus while it is open and gives it back to where it came from. */
export function Dialog({ title, about, onClose, children, wide = false, reading = false }: DialogProps) {
  const id = useOwnId("dialog");
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => {
    const element = dialog.current;
    const opener = document.activeElement;
    element?.showModal();
    return () => {
      element?.close();
      if (opener instanceof HTMLElement && opener.isConnected) opener.focus({ preventScroll: true });
    };
  }, []);
  return (
    <dialog
      ref={dialog}
      class={`${css["dialog"]} ${wide ? "wide" : ""}`}
      aria-labelledby={id}
      onCancel={(event) => {
        event.preventDefault();
        onClose();
      }}
      onClose={onClose}
      onPointerDown={(event) => {
        // Only the backdrop is the dialog itself: everything else lies in the box below.
        if (event.target === event.currentTarget) onClose();
      }}
    >
      <div class={css["dialog-box"]}>
        <header class={css["dialog-head"]}>
          <div>
            <h2 id={id}>{title}</h2>
            {about !== undefined && <p>{about}</p>}
          </div>
          <IconButton icon="close" label="Close" kind="quiet" onClick={onClose} />
        </header>
        <div class={css["dialog-body"]} {...(reading ? { tabIndex: 0 } : {})}>
          {children}
        </div>
      </div>
    </dialog>
  );
}
