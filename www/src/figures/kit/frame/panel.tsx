import type { ComponentChildren } from "preact";
import layout from "./layout.module.css";

export interface PanelProps {
  /** Stands first below it, and strong. */
  name?: string;
  /** What is said of it beside its name. */
  words?: string;
  /** What else is said below it. */
  caption?: ComponentChildren;
  children: ComponentChildren;
  class?: string | undefined;
}

/** One picture of several, with what is said of it. */
export function Panel({ name, words, caption, children, class: own = "" }: PanelProps) {
  return (
    <figure class={`${layout["panel"]} ${own}`}>
      {children}
      {(name !== undefined || caption !== undefined) && (
        <figcaption>
          {name !== undefined && (
            <span class={layout["side-name"]}>
              {name} {words !== undefined && <span>{words}</span>}
            </span>
          )}
          {caption}
        </figcaption>
      )}
    </figure>
  );
}
