import { useMemo } from "preact/hooks";
import { Graph } from "../../kit/connectedness/overlap-graph";
import { cutKoch, PEAK } from "../../kit/maps/families";
import { Picture } from "../../kit/picture/picture";
import { Pair } from "../../kit/picture/small";

/** Koch's curve over its graph. */
export function Thumb() {
  const maps = useMemo(() => cutKoch(0), []);
  const edges = [0, 1, 2].map((i) => ({ between: [i, i + 1] as [number, number], at: 0, pixel: 0 }));
  const angles = [Math.PI, Math.PI / 2, 0, -Math.PI / 2];
  return (
    <Pair>
      <Picture maps={maps} box={{ x0: 0, y0: 0, x1: 1, y1: PEAK }} label={null} />
      <Graph count={4} angles={angles} edges={edges} still />
    </Pair>
  );
}
