import { gasket } from "../../kit/maps/families";
import { STARTS } from "../../kit/maps/iterates";
import { Iterates } from "../../kit/picture/iterates";
import { Pair } from "../../kit/picture/small";

const MAPS = gasket(0.5);
const BOX = { x0: 0, y0: 0, x1: 1, y1: 1 };
const START = { outlines: STARTS.letter };

/** A letter, and what becomes of it. */
export function Thumb() {
  return (
    <Pair>
      {[1, 4].map((steps) => (
        <Iterates key={steps} maps={MAPS} steps={steps} start={START} box={BOX} label={null} />
      ))}
    </Pair>
  );
}
