import { useMemo } from "preact/hooks";
import { gasket } from "../../kit/maps/families";
import { Small } from "../../kit/picture/small";
import { play } from "./dice";
import { Shade } from "./shade";
import { TRIANGLE } from "./shapes";

export function Thumb() {
  const game = useMemo(() => play(gasket(0.5), [6, 3, 1], 40_000), []);
  return (
    <Small shape={4 / 3}>
      <Shade game={game} box={TRIANGLE} label={null} />
    </Small>
  );
}
