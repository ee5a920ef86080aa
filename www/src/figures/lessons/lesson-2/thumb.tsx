import { useMemo } from "preact/hooks";
import { Board } from "./board";
import { Throws } from "./throws";

export function Thumb() {
  const game = useMemo(() => {
    const thrown = new Throws();
    thrown.roll(700);
    return thrown;
  }, []);
  return <Board game={game} count={game.count} label={null} />;
}
