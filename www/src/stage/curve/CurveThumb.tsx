import { useMemo } from "preact/hooks";
import { type CurveMorph, curveBoxAt } from "#document/curve/curve";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import { stageStyle } from "../picture-style";
import { curveThumb } from "./thumb";

const SIZE = { width: 160, height: 104 };

/** A small picture of a curve at a moment of its morph. Whatever holds it says what it shows. */
export function CurveThumb({ morph, s }: { morph: CurveMorph | null; s: number }) {
  const { palette } = stageStyle.value;
  const bitmap = useMemo(() => {
    if (!morph) return null;
    return curveThumb(morph, s, curveBoxAt(morph, s), SIZE, palette);
  }, [morph, s, palette]);
  return <Thumbnail bitmap={bitmap} />;
}
