import { useMemo } from "preact/hooks";
import { gasket } from "../../kit/maps/families";
import { Picture } from "../../kit/picture/picture";

const MEETING = { x0: 0.36, x1: 0.64, y0: -0.05, y1: 0.16 };

export function Thumb() {
  const maps = useMemo(() => gasket(0.5), []);
  return <Picture maps={maps} box={MEETING} margin={0} label={null} />;
}
