import { useMemo } from "preact/hooks";
import { UNIT } from "#geometry/boxes";
import { boxOfPoints } from "#geometry/point-box";
import { loadCurves, rough } from "#wasm/curve";
import { Small } from "../../kit/picture/small";
import { type OutlineLine, OutlineView } from "./outline-view";

/** What must be there before it is drawn. */
export const needs = [loadCurves];

/** The leaf of the gallery, and its knots. */
export function Thumb() {
  const lines = useMemo((): OutlineLine[] => {
    const leaf = rough.curvePresets()[0];
    if (!leaf) return [];
    const morph = new rough.CurveMorph(leaf.curve, null);
    try {
      const points = morph.polyline(0, { tolerance: 0.004 });
      return [
        { points, colour: 2, width: 1.25, closed: true, filled: true },
        { points: leaf.curve.knots.flat(), colour: 5, dots: 3 },
      ];
    } finally {
      morph.free();
    }
  }, []);
  const box = useMemo(() => boxOfPoints(lines[0]?.points ?? []) ?? UNIT, [lines]);
  return (
    <Small>
      <OutlineView lines={lines} box={box} label={null} />
    </Small>
  );
}
