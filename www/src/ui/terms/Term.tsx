import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { listenForEscape } from "../escape";
import { lazily } from "../lazy";
import * as messages from "../messages";
import css from "./term.module.css";
import type { TermName } from "./words";

const Meaning = lazily(() => import("./Meaning").then((module) => module.Meaning));

/** A word of the page that says, when it is pressed, what it means, and which lesson is about it. */
export function Term({ name, children }: { name: TermName; children: ComponentChildren }) {
  const [open, setOpen] = useState(false);
  const root = useRef<HTMLSpanElement>(null);
  const word = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    if (!open) return;
    const outside = (event: Event) => {
      if (event.target instanceof Node && root.current?.contains(event.target) !== true) setOpen(false);
    };
    document.addEventListener("pointerdown", outside, true);
    document.addEventListener("focusin", outside);
    const stop = listenForEscape(() => {
      setOpen(false);
      word.current?.focus();
    });
    return () => {
      document.removeEventListener("pointerdown", outside, true);
      document.removeEventListener("focusin", outside);
      stop();
    };
  }, [open]);
  return (
    <span class={css["term"]} ref={root}>
      <button
        type="button"
        ref={word}
        class={css["word"]}
        title={messages.whatThisMeans}
        aria-expanded={open}
        onClick={() => setOpen(!open)}
      >
        {children}
      </button>
      {open && <Meaning name={name} />}
    </span>
  );
}
