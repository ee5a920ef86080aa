import { useMemo } from "preact/hooks";
import { gasket, turnedGasket } from "../../kit/maps/families";
import { boxAround, mapsAt } from "../../kit/maps/morphs";
import { Picture } from "../../kit/picture/picture";
import { Pair } from "../../kit/picture/small";

/** The same moment both ways. */
export function Thumb() {
  const pictures = useMemo(() => {
    const pair = { from: turnedGasket(), to: gasket(0.5) };
    const maps = (["linear", "polar"] as const).map((mode) => mapsAt(pair, [0.35, 0.35], mode));
    return { maps, box: boxAround(maps) };
  }, []);
  return (
    <Pair>
      {pictures.maps.map((maps, i) => (
        <Picture key={i === 0 ? "linear" : "polar"} maps={maps} box={pictures.box} label={null} />
      ))}
    </Pair>
  );
}
