import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import type { Box } from "#document/framing";
import { Bent } from "../../kit/picture/deformed";
import { Small } from "../../kit/picture/small";
import { FERN, swayOf } from "./fern";

/** Where the fern is as it leans to a side. */
const LEANING: Box = { x0: -2.4, y0: -0.1, x1: 3.9, y1: 10.1 };

export function Thumb() {
  const bend = useMemo(() => bendAt(swayOf({ kb: 0 }), 0.2), []);
  return (
    <Small shape={0.62}>
      <Bent maps={FERN} box={LEANING} bend={bend} aspect={0.62} grid={0} label={null} />
    </Small>
  );
}
