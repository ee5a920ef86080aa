/** Small pictures of the lessons, made by the same parts as the lessons themselves. */
import { useMemo } from "preact/hooks";
import { Board } from "./board";
import { gasket } from "./families";
import { Picture } from "./picture";
import { Throws } from "./throws";

const MEETING = { x0: 0.36, x1: 0.64, y0: -0.05, y1: 0.16 };

export function Meeting() {
  const maps = useMemo(() => gasket(0.5), []);
  return <Picture maps={maps} box={MEETING} margin={0} label={null} />;
}

export function Game() {
  const game = useMemo(() => {
    const thrown = new Throws();
    thrown.roll(700);
    return thrown;
  }, []);
  return <Board game={game} count={game.count} label={null} />;
}
