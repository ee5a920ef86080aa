import { Drawn } from "../../kit/picture/annotated";
import { boxesOf, GRIDDED } from "./boxes";
import { Counted } from "./counted";

const UNIT = { x0: 0, y0: 0, x1: 1, y1: 1 };
const LEVEL = 3;
const SIDE = 1 / 2 ** LEVEL;

export function Thumb() {
  return (
    <Drawn maps={GRIDDED.gasket.maps} box={UNIT} label={null}>
      {(place) => <Counted boxes={boxesOf(GRIDDED.gasket, LEVEL)} side={SIDE} place={place} />}
    </Drawn>
  );
}
