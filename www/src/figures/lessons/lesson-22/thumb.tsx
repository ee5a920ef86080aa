import { useMemo } from "preact/hooks";
import { GASKET, LIFT_BOX } from "../../fujimoto/deformations/lifted-gasket";
import { Bent } from "../../kit/picture/deformed";
import { Small } from "../../kit/picture/small";
import { lifted } from "./answer";

export function Thumb() {
  const bend = useMemo(() => lifted(2, 0.75), []);
  return (
    <Small>
      <Bent maps={GASKET} box={LIFT_BOX} bend={bend} grid={0} label={null} />
    </Small>
  );
}
