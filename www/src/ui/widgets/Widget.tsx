import type { ComponentChildren } from "preact";
import css from "./widgets.module.css";

interface WidgetProps {
  name: string;
  /** Where there is only one. */
  state?: string;
  wide?: boolean;
  children: ComponentChildren;
}

/** The states of one widget, under its name in the code. */
export function Widget({ name, state, wide = false, children }: WidgetProps) {
  return (
    <section class={css["widget"]} aria-label={name}>
      <h3>{name}</h3>
      {state === undefined ? (
        children
      ) : (
        <State name={state} wide={wide}>
          {children}
        </State>
      )}
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
