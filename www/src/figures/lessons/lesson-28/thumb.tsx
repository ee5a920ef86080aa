import { useMemo } from "preact/hooks";
import { Picture } from "../../kit/picture/picture";
import { SHADOW_BOX, shadowMaps } from "../lesson-24/shapes";
import { SHAPE, turnedMaps } from "./turned";

export function Thumb() {
  const maps = useMemo(() => shadowMaps(turnedMaps(SHAPE, 40), { turn: 0, tilt: 20 }), []);
  return <Picture maps={maps} box={SHADOW_BOX} label={null} />;
}
