import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { shareWords } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { prover } from "#wasm/proof";
import layout from "../../kit/frame/layout.module.css";
import { Square } from "../../kit/locus/locus-square";
import { useChart } from "../../kit/locus/morph-locus";
import { mapsAt, STRAIGHT } from "../../kit/maps/morphs";
import { point } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import lessonCss from "../frame/lesson.module.css";
import { Coordinate, EPSILON, ends, judge, SIZE } from "./leading";
import { type Side, sideOf } from "./sides";

export function Exercises() {
  return (
    <>
      <On
        number={1}
        side="turning first"
        first={[0.8, 0.3]}
        ask="Lead the morph so that it stays in one piece, with the waypoint below the straight way: it turns first and moves later, so u is more than v."
        hints={[
          "Both parts of the way have to stay in the light. Where is the map light from A on, to the right?",
          "Bring the waypoint to u = 0.5, and then down step by step.",
        ]}
      />
      <On
        number={2}
        side="moving first"
        first={[0.1, 0.9]}
        ask="There is another way, on the other side: above the straight way, where the morph moves first and turns later. Find a waypoint there over which it stays in one piece."
        hints={[
          "Stay near to A with u: then the first part of the way is steep, and the second one flat.",
          "Try u = 0.2, and v a little below 0.5.",
        ]}
      />
    </>
  );
}

interface OnProps {
  number: number;
  side: Side;
  first: Uv;
  ask: string;
  hints: readonly string[];
}

/** A way that holds, on the side that is asked. */
function On({ number, side, first, ask, hints }: OnProps) {
  const [way, setWay] = useKept<Uv>(`x${number}.way`, first, point(-1, 2, 2));
  const wish = useMemo(() => ({ ends: ends(), options: {}, size: SIZE }), []);
  const field = useChart(wish);
  const points = useMemo((): Uv[] => [[0, 0], way, [1, 1]], [way]);
  const check = useMemo(() => judge(points), [points]);
  const here = useMemo(
    () => prover().connectedness({ maps: mapsAt(ends(), way) }, { epsilon: EPSILON }),
    [way],
  );
  const right = sideOf(way) === side;
  const words = check.holds
    ? right
      ? "It stays in one piece at each moment judged."
      : `It holds, but this waypoint lies ${sideOf(way) === "on the line" ? "on the straight way" : `on the side of ${sideOf(way)}`}.`
    : here.verdict === "disconnected"
      ? "The shape at the waypoint is in pieces itself."
      : `At the waypoint all is well; on the way a gap of ${shareWords(check.gap)} opens.`;
  const move = ([u, v]: Uv) => setWay([Number(u.toFixed(2)), Number(v.toFixed(2))]);
  return (
    <Exercise number={number} ask={ask} hints={hints} solved={check.holds && right} status={words}>
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Square
          field={field}
          label={`The map of shapes with the path from A over (${fixed(way[0])}, ${fixed(way[1])}) to B. ${words}`}
          lines={[
            { name: "straight", points: STRAIGHT, dashed: true },
            { name: "led", points },
          ]}
          point={way}
          onMove={move}
        />
        <div class={lessonCss["ask"]}>
          <Coordinate name="u" about="turn and stretch" value={way[0]} onChange={(u) => move([u, way[1]])} />
          <Coordinate name="v" about="move" value={way[1]} onChange={(v) => move([way[0], v])} />
        </div>
      </div>
    </Exercise>
  );
}
