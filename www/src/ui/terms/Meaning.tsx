import { useLayoutEffect, useRef } from "preact/hooks";
import * as messages from "../messages";
import css from "./term.module.css";
import { type TermName, WORDS } from "./words";

/** What a word means, beside it, with the way to its lesson. */
export function Meaning({ name }: { name: TermName }) {
  const box = useRef<HTMLSpanElement>(null);
  // Moved in from the edge of the window, below the word or, where there is no room, above it.
  useLayoutEffect(() => {
    const { current } = box;
    if (!current) return;
    const { left, right, bottom, height } = current.getBoundingClientRect();
    const over = Math.max(0, right + 8 - innerWidth);
    current.style.translate = `${-Math.min(over, left - 8)}px 0`;
    if (bottom > innerHeight - 8 && bottom - 2 * height > 8) current.dataset["above"] = "";
  }, []);
  const found = WORDS.find(({ word }) => word === name);
  return (
    found && (
      <span class={css["meaning"]} role="note" ref={box}>
        {found.means}{" "}
        {found.lesson && (
          <a href={`#learn/${found.lesson}`} aria-label={messages.lessonOn(name)}>
            {messages.lesson}
          </a>
        )}
        {name === "proved" && (
          <>
            {" · "}
            <a href="./theorems.html" target="_blank" rel="noopener">
              {messages.whyProof}
            </a>
          </>
        )}
      </span>
    )
  );
}
