import type { ComponentChildren } from "preact";
import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import type { Box } from "#document/framing";
import type { Bend, Colouring, Deformation, MapRow } from "#wasm/api";
import layout from "../../kit/frame/layout.module.css";
import { Bent } from "../../kit/picture/deformed";
import { numbersOf, type Panel } from "./deformations";
import css from "./panels.module.css";

export interface PanelsProps {
  panels: readonly Panel[];
  maps: MapRow[];
  box: Box;
  t: number;
  /** The whole of a panel's deformation. */
  deformationOf: (settings: Partial<Deformation>) => Deformation;
  /** What is seen in a panel, in words. */
  words: (panel: Panel) => string;
  aspect?: number;
  colouring?: Colouring;
  /** How many side by side, where there is room. */
  columns: 3 | 4;
  /** One more, at the end. */
  children?: ComponentChildren;
}

/** The panels of a figure, all at the same moment. */
export function Panels({ panels, columns, children, ...rest }: PanelsProps) {
  return (
    <div class={css["bent-panels"]} style={{ "--columns": String(columns) }}>
      {panels.map((panel) => (
        <Single key={panel.letter} panel={panel} {...rest} />
      ))}
      {children}
    </div>
  );
}

function Single({
  panel,
  t,
  deformationOf,
  words,
  ...picture
}: Omit<PanelsProps, "panels" | "columns" | "children"> & { panel: Panel }) {
  const deformation = useMemo(() => deformationOf(panel.settings), [panel, deformationOf]);
  const bend = useMemo<Bend>(() => bendAt(deformation, t), [deformation, t]);
  return (
    <figure class={layout["panel"]}>
      <Bent {...picture} bend={bend} label={words(panel)} />
      <figcaption>
        <span class={layout["side-name"]}>
          {panel.letter} <span>{panel.words}</span>
        </span>
        <span class="number">{numbersOf(panel)}</span>
      </figcaption>
    </figure>
  );
}
