import "./overlay.css";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { IconButton } from "../controls/Button";
import { useOwnId } from "../id";
import * as messages from "../messages";
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
  /** Where the focus goes where nothing had it: what a key opened has no button that it came from. */
  back?: () => HTMLElement | null;
}

/** A native modal dialog: it holds the focus while it is open and gives it back to where it came from. */
export function Dialog(props: DialogProps) {
  const { title, about, onClose, children, wide = false, reading = false } = props;
  const latest = useRef(props);
  latest.current = props;
  const id = useOwnId("dialog");
  const dialog = useRef<HTMLDialogElement>(null);
  const heading = useRef<HTMLHeadingElement>(null);
  const body = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = dialog.current;
    const opener = document.activeElement;
    element?.showModal();
    // Left to itself the browser chooses the first button, which closes it.
    if (!element?.querySelector("[autofocus]")) (latest.current.reading ? body : heading).current?.focus();
    return () => {
      element?.close();
      const had = opener instanceof HTMLElement && opener !== document.body && opener.isConnected;
      (had ? opener : latest.current.back?.())?.focus({ preventScroll: true });
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
            <h2 id={id} ref={heading} tabIndex={-1}>
              {title}
            </h2>
            {about !== undefined && <p>{about}</p>}
          </div>
          <IconButton icon="close" label={messages.close} kind="quiet" onClick={onClose} />
        </header>
        <div class={css["dialog-body"]} ref={body} {...(reading ? { tabIndex: 0 } : {})}>
          {children}
        </div>
      </div>
    </dialog>
  );
}
