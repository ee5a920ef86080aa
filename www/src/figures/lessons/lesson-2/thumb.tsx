import { useMemo } from "preact/hooks";
import { Small } from "../../kit/picture/small";
import { Board } from "./board";
import { Throws } from "./throws";

export function Thumb() {
  const game = useMemo(() => {
    const thrown = new Throws();
    thrown.roll(700);
    return thrown;
  }, []);
  return (
    <Small shape={400 / 360}>
      <Board game={game} count={game.count} label={null} />
    </Small>
  );
}
