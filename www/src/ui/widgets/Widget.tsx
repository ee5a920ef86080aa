import type { ComponentChildren } from "preact";
import css from "./widgets.module.css";

/** The states of one widget, under its name in the code. */
export function Widget({ name, children }: { name: string; children: ComponentChildren }) {
  return (
    <section class={css["widget"]} aria-label={name}>
      <h3>{name}</h3>
      {children}
    </section>
  );
}

interface StateProps {
  name: string;
  /** As wide as there is room. */
  wide?: boolean;
  children: ComponentChildren;
}

export function State({ name, wide = false, children }: StateProps) {
  return (
    <div class={`${css["state"]} ${wide ? css["stretched"] : ""}`}>
      <p class={css["state-name"]}>{name}</p>
      {children}
    </div>
  );
}

/** What many languages make of a short label. */
export const LONG = "A label with many more words than there is room for in one line of a side panel";
