import { useMemo } from "preact/hooks";
import { preset } from "../../kit/frame/studio-link";
import { boxAround, mapsAt } from "../../kit/maps/morphs";
import { Picture } from "../../kit/picture/picture";

/** A moment of the led morph. */
export function Thumb() {
  const maps = useMemo(
    () => mapsAt({ from: preset("dragon-3").maps, to: preset("terdragon").maps }, [0.3, 0.6]),
    [],
  );
  const box = useMemo(() => boxAround([maps]), [maps]);
  return <Picture maps={maps} box={box} label={null} />;
}
