import type { ComponentChildren } from "preact";
import css from "./small.module.css";

/** A drawing that keeps its shape in a small picture. */
export function Small({ shape = 1, children }: { shape?: number; children: ComponentChildren }) {
  return (
    <span class={css["small"]} style={{ "--shape": String(shape) }}>
      {children}
    </span>
  );
}

/** Two drawings beside each other. */
export function Pair({ spaced = false, children }: { spaced?: boolean; children: ComponentChildren }) {
  return <span class={`${css["pair"]} ${spaced ? css["spaced"] : ""}`}>{children}</span>;
}
