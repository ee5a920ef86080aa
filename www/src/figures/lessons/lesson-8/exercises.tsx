import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { verdictPhrase } from "#format/verdict";
import type { Connectedness } from "#wasm/api";
import layout from "../../kit/frame/layout.module.css";
import { EXACT, VerdictChip } from "../../kit/frame/verdict";
import { type Complex, mapsOf } from "../../kit/locus/set-m";
import { boxAround } from "../../kit/maps/morphs";
import { Picture } from "../../kit/picture/picture";
import { point } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { useVerdict } from "../../kit/workers";
import { Exercise } from "../frame/exercise";
import lessonCss from "../frame/lesson.module.css";
import { complexWords, Sliders } from "./disc";
import { isLargeDust, isSmallPiece, LARGE, SMALL } from "./found";

export function Exercises() {
  return (
    <>
      <Searched
        number={1}
        first={[0.4, 0.5]}
        ask={`From 0.7071 on all shapes are in one piece. Find dust whose |s| is nearly so large: ${fixed(LARGE, 1)} or more.`}
        hints={[
          "At most angles there is no such dust. Try angles at which a turn, done twice, is a simple one.",
          "Look straight above 0, where the real part is 0: there s times s is a real number below 0.",
        ]}
        isFound={isLargeDust}
        wrong={(s, { verdict }) =>
          verdict === "disconnected"
            ? "It is dust, but |s| is too small."
            : Math.hypot(...s) > LARGE - 1e-9
              ? "It is large enough, but in one piece."
              : "It is in one piece."
        }
        right="It is dust, although so much of it is left at each step."
      />
      <Searched
        number={2}
        first={[0.3, 0.4]}
        ask={`With |s| below ½ all is dust. There are just two s of size ${fixed(SMALL, 1)} whose shape is in one piece. Find one.`}
        hints={[
          "Two pieces of half the size: together they are just as long as the whole. How must they lie, so that nothing is lost?",
          "They have to lie one after the other in a line. So the shape must not turn.",
        ]}
        isFound={isSmallPiece}
        wrong={(s, { verdict }) =>
          verdict === "disconnected"
            ? "It is dust."
            : Math.hypot(...s) > SMALL + 1e-9
              ? "It is in one piece, but |s| is more than 0.5."
              : "Nothing is proved here."
        }
        right="It is a line segment: each piece is one half of it."
      />
    </>
  );
}

interface SearchedProps {
  number: number;
  first: Complex;
  ask: string;
  hints: readonly string[];
  isFound: (s: Complex, answer: Connectedness) => boolean;
  wrong: (s: Complex, answer: Connectedness) => string;
  right: string;
}

/** A shape of two pieces that is to be found by its number. */
function Searched({ number, first, ask, hints, isFound, wrong, right }: SearchedProps) {
  const [s, setS] = useKept<Complex>(`x${number}.s`, first, point(-1, 1));
  const maps = useMemo(() => mapsOf(s), [s]);
  const box = useMemo(() => boxAround([maps]), [maps]);
  const judged = useVerdict(maps, EXACT);
  const answer = judged?.maps === maps ? judged.answer : null;
  const found = answer && isFound(s, answer);
  const size = `|s| is ${fixed(Math.hypot(...s), 4)}.`;
  return (
    <Exercise
      number={number}
      ask={ask}
      hints={hints}
      solved={found}
      status={`${size} ${answer === null ? "Looking …" : found ? right : wrong(s, answer)}`}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Picture
          maps={maps}
          box={box}
          label={`The shape of s = ${complexWords(s)}: ${verdictPhrase(answer, EXACT)}.`}
        />
        <div class={lessonCss["ask"]}>
          <Sliders s={s} onMove={([re, im]) => setS([Number(re.toFixed(2)), Number(im.toFixed(2))])} />
          <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} stale={judged?.maps !== maps} />
        </div>
      </div>
    </Exercise>
  );
}
