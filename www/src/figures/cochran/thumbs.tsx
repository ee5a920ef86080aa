/** Small pictures of the figures on rough curves, made by the same parts as the figures themselves. */
import { useMemo } from "preact/hooks";
import { rough } from "#wasm/curve";
import { FIGURE_1, interpolated } from "./figure-1/page";
import { TABLE_1_GRAPH } from "./figure-2/page";
import { EYE } from "./figure-3/page";
import { SpaceView } from "./figure-3/space-curve";
import { boxOfPoints, type OutlineLine, OutlineView } from "./figure-7/outline-view";
import { arrowhead, heightsAlong, TOP } from "./graphs/arrowhead";
import { byPiece, rangeOf } from "./graphs/graphs";
import { TABLE_2 } from "./graphs/printed-tables";
import { type Dots, type Line, Profile } from "./graphs/profile";
import { TABLE_3_GRAPH } from "./graphs/table-3";

const NONE: readonly number[] = [];
const NO_LINES: readonly Line[] = [];

function Still({ lines, t }: { lines: readonly Line[]; t: readonly [number, number] }) {
  const y = rangeOf(
    lines.map(({ points }) => points),
    { min: 0, max: 1 },
  );
  return (
    <Profile
      bare
      label={null}
      x={{ min: t[0], max: t[1], ticks: NONE }}
      y={{ ...y, ticks: NONE }}
      lines={lines}
    />
  );
}

export function Interpolated() {
  const lines = useMemo(() => {
    const graph = interpolated(FIGURE_1.points, FIGURE_1.c);
    const samples = rough.sampleGraph(graph, { tolerance: 0.01, most: 4000 });
    return byPiece(graph, samples).map((points, colour) => ({ points, colour, width: 1.25 }));
  }, []);
  return <Still lines={lines} t={[0, 1]} />;
}

export function TwoMaps() {
  const lines = useMemo(
    (): Line[] => [
      {
        points: rough.sampleGraph(TABLE_1_GRAPH, { tolerance: 0.01, most: 4000 }),
        colour: "ink",
        width: 1.1,
      },
    ],
    [],
  );
  return <Still lines={lines} t={[-1, 1]} />;
}

export function InSpace() {
  const points = useMemo(() => arrowhead(5), []);
  return <SpaceView points={points} eye={EYE} shadows label={null} />;
}

/** The printed rows of Table 2 over a and b, as large as they are popular. */
export function Votes() {
  const dots = useMemo(
    () =>
      TABLE_2.map(({ hits, map }, i): Dots => {
        return {
          points: [map[3], map[4]],
          colour: i < 2 ? 5 : 1,
          size: 0.2 * Math.sqrt(hits),
          hollow: i > 1,
        };
      }),
    [],
  );
  return (
    <Profile
      bare
      label={null}
      x={{ min: -1.4, max: 1, ticks: NONE }}
      y={{ min: -1.1, max: 2.1, ticks: NONE }}
      lines={NO_LINES}
      dots={dots}
    />
  );
}

/** Heaps that fall as those of votes do. */
export function Heaps() {
  const lines = useMemo(
    () =>
      Array.from({ length: 34 }, (_, i): Line => {
        return { points: [i, 0, i, 1 / (1 + 0.28 * i)], colour: i % 5 === 0 ? 5 : 1, width: 3 };
      }),
    [],
  );
  return (
    <Profile
      bare
      label={null}
      x={{ min: -1, max: 34, ticks: NONE }}
      y={{ min: 0, max: 1.05, ticks: NONE }}
      lines={lines}
    />
  );
}

/** The seven maps over what they were found for. */
export function Overlaid() {
  const lines = useMemo((): Line[] => {
    const samples = rough.sampleGraph(TABLE_3_GRAPH, { tolerance: 0.01, most: 4000 });
    return [
      { points: heightsAlong(5, TOP), colour: "quiet", width: 1 },
      ...byPiece(TABLE_3_GRAPH, samples).map((points, i) => ({ points, colour: i % 2, width: 1.25 })),
    ];
  }, []);
  return <Still lines={lines} t={[0, 1]} />;
}

/** The leaf of the gallery, and its knots. */
export function Leaf() {
  const lines = useMemo((): OutlineLine[] => {
    const leaf = rough.curvePresets()[0];
    if (!leaf) return [];
    const morph = new rough.CurveMorph(leaf.curve, null);
    try {
      const points = morph.polyline(0, { tolerance: 0.004 });
      return [
        { points, colour: 2, width: 1.25, closed: true, filled: true },
        { points: leaf.curve.knots.flat(), colour: 5, dots: 3 },
      ];
    } finally {
      morph.free();
    }
  }, []);
  const box = useMemo(() => boxOfPoints(lines[0]?.points ?? []), [lines]);
  return <OutlineView lines={lines} box={box} label={null} />;
}

export function Top() {
  const lines = useMemo((): Line[] => [{ points: heightsAlong(5, TOP), colour: "ink", width: 1.25 }], []);
  return <Still lines={lines} t={[0, 1]} />;
}
