/** Small pictures of the figures on rough curves, made by the same parts as the figures themselves. */
import { useMemo } from "preact/hooks";
import { frond } from "../engine/wasm";
import { arrowhead, heightsAlong, TOP } from "./arrowhead";
import { FIGURE_1, interpolated } from "./c1";
import { TABLE_1_GRAPH } from "./c2";
import { EYE } from "./c3";
import { byPiece, rangeOf } from "./graphs";
import { type Line, Profile } from "./profile";
import { SpaceView } from "./space-view";

const NONE: readonly number[] = [];

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
    const samples = frond.sampleGraph(graph, { tolerance: 0.01, most: 4000 });
    return byPiece(graph, samples).map((points, colour) => ({ points, colour, width: 1.25 }));
  }, []);
  return <Still lines={lines} t={[0, 1]} />;
}

export function TwoMaps() {
  const lines = useMemo(
    (): Line[] => [
      {
        points: frond.sampleGraph(TABLE_1_GRAPH, { tolerance: 0.01, most: 4000 }),
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

export function Top() {
  const lines = useMemo((): Line[] => [{ points: heightsAlong(5, TOP), colour: "ink", width: 1.25 }], []);
  return <Still lines={lines} t={[0, 1]} />;
}
