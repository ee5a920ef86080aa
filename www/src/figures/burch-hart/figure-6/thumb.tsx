import { useMemo } from "preact/hooks";
import { uvAt } from "#geometry/path";
import { boxAround, mapsAt } from "../../kit/maps/morphs";
import { Picture } from "../../kit/picture/picture";
import { useValue } from "../../kit/workers";
import { chart, ends } from "../dragon/dragon";

export function Thumb() {
  const pair = useValue(ends);
  const points = useValue(chart).plan?.points ?? null;
  const maps = useMemo(() => (points ? mapsAt(pair, uvAt(points, 0.6)) : null), [pair, points]);
  const box = useMemo(() => boxAround(maps ? [maps] : []), [maps]);
  return maps && <Picture maps={maps} box={box} label={null} />;
}
