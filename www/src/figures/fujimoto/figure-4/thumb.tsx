import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import { Bent } from "../../kit/picture/deformed";
import { Small } from "../../kit/picture/small";
import { GASKET, LIFT_BOX, liftOf } from "../deformations/lifted-gasket";

export function Thumb() {
  const bend = useMemo(() => bendAt(liftOf({ kb: 0 }), 1), []);
  return (
    <Small>
      <Bent maps={GASKET} box={LIFT_BOX} bend={bend} grid={0} label={null} />
    </Small>
  );
}
