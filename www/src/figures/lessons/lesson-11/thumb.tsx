import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import { FAR_CORNER, GASKET, liftOf } from "../../fujimoto/deformations/lifted-gasket";
import { Bent } from "../../kit/picture/deformed";
import { Small } from "../../kit/picture/small";

/** The far corner of a gasket that is pulled elsewhere. */
export function Thumb() {
  const bend = useMemo(() => bendAt(liftOf({ kb: 0 }), 1), []);
  return (
    <Small>
      <Bent maps={GASKET} box={FAR_CORNER} bend={bend} grid={0} label={null} />
    </Small>
  );
}
