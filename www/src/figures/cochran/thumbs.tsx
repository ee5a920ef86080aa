/** Small pictures of the figures of Cochran, Hart & Flynn, by the addresses of their pages. */
import { useMemo } from "preact/hooks";
import { UNIT } from "#geometry/boxes";
import { boxOfPoints } from "#geometry/point-box";
import { TABLE_1 as TABLE_1_GRAPH, TABLE_3 as TABLE_3_GRAPH } from "#tools/fit/graph/printed";
import { loadCurves, rough } from "#wasm/curve";
import type { Thumbs } from "../figure";
import { Pair, Small } from "../kit/picture/small";
import { FIGURE_1, interpolated } from "./figure-1/interpolation";
import { FROM_CORNER, SpaceView } from "./figure-3/space-curve";
import { type OutlineLine, OutlineView } from "./figure-7/outline-view";
import { arrowhead, heightsAlong, TOP } from "./graphs/arrowhead";
import { byPiece } from "./graphs/graphs";
import { TABLE_2 } from "./graphs/printed-tables";
import { type Dots, type Line, Profile } from "./graphs/profile";
import { NO_TICKS, Still } from "./graphs/still";
import { curveThrough, drawn, FACTORS, PLACES } from "./section-2-4/plane-curve";

function Figure1() {
  const lines = useMemo(() => {
    const graph = interpolated(FIGURE_1.points, FIGURE_1.c);
    const samples = rough.sampleGraph(graph, { tolerance: 0.01, most: 4000 });
    return byPiece(graph, samples).map((points, colour) => ({ points, colour, width: 1.25 }));
  }, []);
  return <Still lines={lines} t={[0, 1]} />;
}

function Section24() {
  const curve = curveThrough(PLACES, FACTORS, [false, false]);
  const lines =
    typeof curve === "string"
      ? []
      : drawn(curve).pieces.map((points, i) => ({ points, colour: i, width: 1.25 }));
  return (
    <Small shape={1.5}>
      <Profile
        label={null}
        bare
        x={{ min: -0.4, max: 1.4, ticks: [] }}
        y={{ min: -0.3, max: 0.9, ticks: [] }}
        lines={lines}
      />
    </Small>
  );
}

function Figure2() {
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

const NO_LINES: readonly Line[] = [];

/** The printed rows of Table 2 over a and b, as large as they are popular. */
function Table2() {
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
      x={{ min: -1.4, max: 1, ticks: NO_TICKS }}
      y={{ min: -1.1, max: 2.1, ticks: NO_TICKS }}
      lines={NO_LINES}
      dots={dots}
    />
  );
}

function Figure3() {
  const points = useMemo(() => arrowhead(5), []);
  return <SpaceView points={points} eye={FROM_CORNER} shadows label={null} />;
}

function Figure4() {
  const lines = useMemo((): Line[] => [{ points: heightsAlong(5, TOP), colour: "ink", width: 1.25 }], []);
  return <Still lines={lines} t={[0, 1]} />;
}

/** Heaps that fall as those of votes do. */
function Figure5() {
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
      x={{ min: -1, max: 34, ticks: NO_TICKS }}
      y={{ min: 0, max: 1.05, ticks: NO_TICKS }}
      lines={lines}
    />
  );
}

/** The seven maps over what they were found for. */
function Figure6() {
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
function Figure7() {
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
  const box = useMemo(() => boxOfPoints(lines[0]?.points ?? []) ?? UNIT, [lines]);
  return (
    <Small>
      <OutlineView lines={lines} box={box} label={null} />
    </Small>
  );
}

/** The leaf of the gallery, first as fine as it is, then as the polygon of its knots. */
function Figure7Steps() {
  const [fine, coarse] = useMemo((): [OutlineLine[], OutlineLine[]] => {
    const leaf = rough.curvePresets()[0];
    if (!leaf) return [[], []];
    const morph = new rough.CurveMorph(leaf.curve, null);
    try {
      const points = morph.polyline(0, { tolerance: 0.004 });
      const shown = { closed: true, filled: true, width: 1.25 } as const;
      return [
        [{ points, colour: "ink", ...shown }],
        [{ points: leaf.curve.knots.flat(), colour: 1, ...shown }],
      ];
    } finally {
      morph.free();
    }
  }, []);
  const box = useMemo(() => boxOfPoints(fine[0]?.points ?? []) ?? UNIT, [fine]);
  return (
    <Pair>
      <OutlineView lines={fine} box={box} label={null} />
      <OutlineView lines={coarse} box={box} label={null} />
    </Pair>
  );
}

export const THUMBS: Thumbs = {
  c1: { Thumb: Figure1, needs: [loadCurves] },
  c24: { Thumb: Section24, needs: [loadCurves] },
  c2: { Thumb: Figure2, needs: [loadCurves] },
  ct2: { Thumb: Table2 },
  c3: { Thumb: Figure3 },
  c4: { Thumb: Figure4 },
  c5: { Thumb: Figure5 },
  c6: { Thumb: Figure6, needs: [loadCurves] },
  c7: { Thumb: Figure7, needs: [loadCurves] },
  c43: { Thumb: Figure7Steps, needs: [loadCurves] },
};
