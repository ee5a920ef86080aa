import { useMemo } from "preact/hooks";
import { frond } from "#wasm/core";
import { preset } from "../../kit/frame/studio-link";
import { boxAround } from "../../kit/maps/morphs";
import { Picture } from "../../kit/picture/picture";

export function Thumb() {
  const { maps, box } = useMemo(() => {
    const { maps } = frond.conjugate(preset("fern"), [0.75, 0.72, -0.4, 0.7, 0, 0]);
    return { maps, box: boxAround([maps]) };
  }, []);
  return <Picture maps={maps} box={box} label={null} />;
}
