import { useMemo } from "preact/hooks";
import { UNIT } from "#geometry/boxes";
import { boxOfPoints } from "#geometry/point-box";
import { loadCurves, rough } from "#wasm/curve";
import { Pair } from "../../kit/picture/small";
import { type OutlineLine, OutlineView } from "../figure-7/outline-view";

/** What must be there before it is drawn. */
export const needs = [loadCurves];

/** The leaf of the gallery, first as fine as it is, then as the polygon of its knots. */
export function Thumb() {
  const [fine, coarse] = useMemo((): [OutlineLine[], OutlineLine[]] => {
    const leaf = rough.curvePresets()[0];
    if (!leaf) return [[], []];
    const morph = new rough.CurveMorph(leaf.curve, null);
    try {
      const points = morph.polyline(0, { tolerance: 0.004 });
      const shown = { closed: true, filled: true, width: 1.25 } as const;
      return [
        [{ points, colour: "ink", ...shown }],
        [{ points: leaf.curve.knots.flat(), colour: 1, ...shown }],
      ];
    } finally {
      morph.free();
    }
  }, []);
  const box = useMemo(() => boxOfPoints(fine[0]?.points ?? []) ?? UNIT, [fine]);
  return (
    <Pair>
      <OutlineView lines={fine} box={box} label={null} />
      <OutlineView lines={coarse} box={box} label={null} />
    </Pair>
  );
}
