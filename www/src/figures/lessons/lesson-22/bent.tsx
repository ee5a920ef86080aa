import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { FAR_CORNER, GASKET, KE, LIFT_BOX } from "../../fujimoto/deformations/lifted-gasket";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { tex } from "../../kit/notation/tex";
import { Bent } from "../../kit/picture/deformed";
import { lifted } from "./answer";
import css from "./bent.module.css";

interface BothProps {
  kb: number;
  delta: number;
  pull?: number;
}

/** The gasket, bent, and its far corner through a lens. */
export function Both({ kb, delta, pull = 1 }: BothProps) {
  const bend = useMemo(() => lifted(kb, delta, pull), [kb, delta, pull]);
  const how = `locality ${fixed(kb)} of ${KE}, roughness ${fixed(delta)}, ${Math.round(100 * pull)}% pulled`;
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]} ${css["both"]}`}>
      <Panel caption="the whole">
        <Bent maps={GASKET} box={LIFT_BOX} bend={bend} label={`The gasket at ${how}`} />
      </Panel>
      <Panel caption="the far corner, nearly fifteen times larger">
        <Bent maps={GASKET} box={FAR_CORNER} bend={bend} grid={0} label={`Its lower left corner at ${how}`} />
      </Panel>
    </div>
  );
}

interface NumberProps {
  value: number;
  onChange: (value: number) => void;
}

export function Locality({ value, onChange }: NumberProps) {
  return (
    <SliderControl
      label="locality"
      symbol={tex`k_b`}
      range={[0, KE]}
      step={0.1}
      value={value}
      text={fixed(value, 1)}
      onChange={onChange}
    />
  );
}

export function Roughness({ value, onChange }: NumberProps) {
  return <SliderControl label="roughness" symbol="δ" step={0.01} value={value} onChange={onChange} />;
}
