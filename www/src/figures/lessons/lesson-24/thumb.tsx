import { useMemo } from "preact/hooks";
import { Picture } from "../../kit/picture/picture";
import { SHADOW_BOX, SPONGE, shadowMaps } from "./shapes";

const EYE = { turn: 24, tilt: 14 };

export function Thumb() {
  const maps = useMemo(() => shadowMaps(SPONGE, EYE), []);
  return <Picture maps={maps} box={SHADOW_BOX} label={null} />;
}
