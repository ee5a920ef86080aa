import type { ComponentChildren } from "preact";
import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import type { Box } from "#document/framing";
import type { Bend, Colouring, Deformation, MapRow } from "#wasm/api";
import { Panel } from "../../kit/frame/panel";
import { Bent } from "../../kit/picture/deformed";
import { type BentPanel, numbersOf } from "./deformations";
import css from "./panels.module.css";

interface PanelsProps {
  panels: readonly BentPanel[];
  maps: MapRow[];
  box: Box;
  t: number;
  /** The whole of a panel's deformation. */
  deformationOf: (settings: Partial<Deformation>) => Deformation;
  /** What is bent, and how it stands at the moment, in words. */
  name: string;
  moment: string;
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
  name,
  moment,
  ...picture
}: Omit<PanelsProps, "panels" | "columns" | "children"> & { panel: BentPanel }) {
  const deformation = useMemo(() => deformationOf(panel.settings), [panel, deformationOf]);
  const bend = useMemo<Bend>(() => bendAt(deformation, t), [deformation, t]);
  return (
    <Panel name={panel.letter} words={panel.words} caption={<span class="number">{numbersOf(panel)}</span>}>
      <Bent
        {...picture}
        bend={bend}
        label={`${name} ${panel.words === "" ? "in between" : panel.words}, ${numbersOf(panel)}, ${moment}`}
      />
    </Panel>
  );
}
