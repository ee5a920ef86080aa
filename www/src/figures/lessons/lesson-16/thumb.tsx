import { gasket, HEIGHT } from "../../kit/maps/families";
import { apply, type Point } from "../../kit/maps/pieces";
import { Drawn, PieceNames } from "../../kit/picture/annotated";

const MAPS = gasket(0.5);
const BOX = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };
const MIDDLE: Point = [0.5, HEIGHT / 3];

export function Thumb() {
  return (
    <Drawn maps={MAPS} box={BOX} label={null}>
      {(place) => <PieceNames at={MAPS.map((map) => place(apply(map, MIDDLE)))} />}
    </Drawn>
  );
}
