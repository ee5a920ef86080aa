import type { ComponentChildren } from "preact";
import { useMemo } from "preact/hooks";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { HEIGHT, unevenGasket } from "../../kit/maps/families";
import { Drawn, middles, PieceNames } from "../../kit/picture/annotated";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import lessonCss from "../frame/lesson.module.css";
import { apart, gapOf, type Pair, type Scales, touches } from "./three";

const WHOLE: Box = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };

export function Exercises() {
  return (
    <>
      <InPoints />
      <ByWayOf />
    </>
  );
}

const SMALL = 0.35;

/** Touching in one point is neither a gap nor an overlap. */
function InPoints() {
  const [second, setSecond] = useKept("x1.second", 0.5, number(0.2, 0.8, 2));
  const [third, setThird] = useKept("x1.third", 0.5, number(0.2, 0.8, 2));
  const scales: Scales = [SMALL, second, third];
  return (
    <Exercise
      number={1}
      ask={`Piece 1 has scale ${SMALL}. Choose the scales of the other two so that piece 1 touches each of them in one point, and no more.`}
      hints={[
        "Along the bottom edge, piece 1 reaches from the left corner as far as its scale, and piece 2 from the right corner as far as its own.",
        "The two scales of a side have to sum to 1. The left side is like the bottom.",
      ]}
      solved={touches(scales, [0, 1]) && touches(scales, [0, 2])}
      status={`${pairWords(scales, [0, 1])} ${pairWords(scales, [0, 2])}`}
    >
      <Trio scales={scales}>
        <Scale piece={2} value={second} onChange={setSecond} />
        <Scale piece={3} value={third} onChange={setThird} />
      </Trio>
    </Exercise>
  );
}

const [FIRST, SECOND, LEAST] = [0.45, 0.5, 0.55];

/** Two pieces may hang together by way of a third. */
function ByWayOf() {
  const [third, setThird] = useKept("x2.third", 0.4, number(0.2, 0.8, 2));
  const scales: Scales = [FIRST, SECOND, third];
  const isWhole = gapOf(scales) === 0;
  return (
    <Exercise
      number={2}
      ask={`Pieces 1 and 2 have scales ${FIRST} and ${fixed(SECOND, 1)}, so there is a gap between them, and it stays. How small may piece 3 be, and the shape be in one piece all the same?`}
      hints={[
        "Pieces 1 and 2 need not touch each other. Which two pairs have to?",
        "Piece 3 has to reach piece 1 along the left side, and piece 2 along the right one. Piece 1 is the smaller.",
      ]}
      solved={isWhole && third < LEAST + 0.001}
      status={`${pairWords(scales, [0, 2])} ${pairWords(scales, [1, 2])} ${
        isWhole
          ? third < LEAST + 0.001
            ? "All hang together by piece 3."
            : "In one piece; but piece 3 may be smaller."
          : "So the shape is in pieces."
      }`}
    >
      <Trio scales={scales}>
        <Scale piece={3} value={third} onChange={setThird} />
      </Trio>
    </Exercise>
  );
}

function pairWords(scales: Scales, pair: Pair): string {
  const names = `Pieces ${pair[0] + 1} and ${pair[1] + 1}`;
  if (touches(scales, pair)) return `${names} touch in one point.`;
  const off = apart(scales, pair);
  return off > 0 ? `${names} are ${fixed(off)} apart.` : `${names} overlap.`;
}

interface TrioProps {
  scales: Scales;
  children: ComponentChildren;
}

/** Three pieces with what changes them beside them. */
export function Trio({ scales, children }: TrioProps) {
  const [one, two, three] = scales;
  const maps = useMemo(() => unevenGasket([one, two, three]), [one, two, three]);
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Drawn
        maps={maps}
        box={WHOLE}
        label={`Three pieces with scales ${scales.map((scale) => fixed(scale)).join(", ")}.`}
      >
        {(place) => <PieceNames at={middles(maps, WHOLE).map(place)} />}
      </Drawn>
      <div class={lessonCss["ask"]}>{children}</div>
    </div>
  );
}

interface ScaleProps {
  piece: number;
  value: number;
  onChange: (scale: number) => void;
}

export function Scale({ piece, value, onChange }: ScaleProps) {
  return (
    <SliderControl
      label={`scale of piece ${piece}`}
      range={[0.2, 0.8]}
      step={0.01}
      value={value}
      onChange={(next) => onChange(Number(next.toFixed(2)))}
    />
  );
}
