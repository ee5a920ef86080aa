import type { ComponentChildren } from "preact";
import css from "./table.module.css";

interface TableProps {
  caption?: ComponentChildren;
  columns: readonly ComponentChildren[];
  /** Where it may be wider than the page, and then scrolls sideways: its name. */
  wide?: string;
  /** The bodies. */
  children: ComponentChildren;
}

/** Measurements: a column each, the first of which names the row. */
export function Table({ caption, columns, wide, children }: TableProps) {
  const table = (
    <table class={css["measurements"]} data-testid={wide === undefined ? undefined : "wide-table"}>
      {caption !== undefined && <caption>{caption}</caption>}
      <thead>
        <tr>
          {columns.map((name, i) => (
            <th key={i} scope="col">
              {name}
            </th>
          ))}
        </tr>
      </thead>
      {children}
    </table>
  );
  // With words at twice their size any table may be wider than a phone.
  if (wide === undefined) return <div class={css["box"]}>{table}</div>;
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached by keys
    <section class={css["wide-table"]} aria-label={wide} tabIndex={0}>
      {table}
    </section>
  );
}
