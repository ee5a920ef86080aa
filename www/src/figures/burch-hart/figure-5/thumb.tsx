import { useMemo } from "preact/hooks";
import { uvAt } from "#geometry/path";
import { boxAround, mapsAt, STRAIGHT } from "../../kit/maps/morphs";
import { Picture } from "../../kit/picture/picture";
import { useValue } from "../../kit/workers";
import { ends } from "../dragon/dragon";

export function Thumb() {
  const pair = useValue(ends);
  const maps = useMemo(() => mapsAt(pair, uvAt(STRAIGHT, 0.6)), [pair]);
  const box = useMemo(() => boxAround([maps]), [maps]);
  return <Picture maps={maps} box={box} label={null} />;
}
