import "./select.css";
import type { ComponentProps } from "preact";

/** One of many, from the browser's own list. */
export function Select(props: ComponentProps<"select">) {
  return <select {...props} class={`select ${props.class ?? ""}`} />;
}
