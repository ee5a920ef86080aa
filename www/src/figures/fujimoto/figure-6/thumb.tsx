import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import type { Box } from "#document/framing";
import { Bent } from "../../kit/picture/deformed";
import { Small } from "../../kit/picture/small";
import { drawnOf, TWIN } from "./drawn-dragon";

/** Where the dragon is as it is drawn. */
const DRAWN: Box = { x0: -0.8, y0: -0.5, x1: 1.75, y1: 1.45 };

export function Thumb() {
  const bend = useMemo(() => bendAt(drawnOf({ kb: 0 }), 0.8), []);
  return (
    <Small shape={1.3}>
      <Bent maps={TWIN} box={DRAWN} bend={bend} aspect={1.3} colouring="grid" grid={0} label={null} />
    </Small>
  );
}
