import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { CURVE, type Curve, onRight, takeTurns } from "./curves";
import { Ends, Square, words } from "./square";

export function Exercises() {
  return (
    <>
      <Placed
        number={1}
        a={{ from: 3.3, to: 0.7, swing: 0.3 }}
        first={{ from: 1.5, to: 2.5, swing: -0.3 }}
        solves={takeTurns}
        ask="A goes from the left side to the bottom. Place the ends of B so that both must meet, whatever they do in between."
        hints={[
          "The ends of A cut the border of the square into two parts. Where are both ends of B now?",
          "One end of B has to be on the short way between the ends of A, over the lower left corner.",
        ]}
      />
      <Placed
        number={2}
        a={{ from: 3.5, to: 1.5, swing: 0.3 }}
        first={{ from: 0.5, to: 0.8, swing: 0.2 }}
        solves={(a, b) => takeTurns(a, b) && onRight(b)}
        ask="A goes from the left side to the right. Place both ends of B on the right side, so that both must meet all the same."
        hints={[
          "It does not matter which sides the ends are on, only in which order they come.",
          "One end of B below that of A, the other one above it.",
        ]}
      />
    </>
  );
}

interface PlacedProps {
  number: number;
  a: Curve;
  first: Curve;
  solves: (a: Curve, b: Curve) => boolean;
  ask: string;
  hints: readonly string[];
}

function Placed({ number, a, first, solves, ask, hints }: PlacedProps) {
  const [b, setB] = useKept(`x${number}.b`, first, CURVE);
  return (
    <Exercise number={number} ask={ask} hints={hints} solved={solves(a, b)} status={words(a, b)}>
      <Square a={a} b={b} onB={setB} />
      <Ends b={b} onB={setB} />
    </Exercise>
  );
}
