/** Closed curves as text. */
import type { Curve } from "#wasm/api";
import type { CurveMap } from "#wasm/curve";
import * as messages from "./messages";

const short = (x: number) => Number(x.toPrecision(9));

/** Knots, edges and the map of each edge. */
export function curveJson(
  name: string,
  { knots, edges }: Curve,
  maps: readonly CurveMap[],
  figures: object | null,
): string {
  return JSON.stringify(
    {
      kind: "closed curve",
      name,
      about: messages.edgeIRunsFrom,
      knots,
      edges: edges.map((edge, i) => (edge ? { ...edge, map: maps[i]?.map?.map(short) ?? null } : null)),
      ...(figures ? { figures: { unit: messages.percentDiagonalOutlinesBounding, ...figures } } : {}),
    },
    null,
    1,
  );
}

/** Corners and control points. */
export function splineJson(
  name: string,
  word: string,
  { nodes, grid, bytes }: { nodes: { at: [number, number]; on: boolean }[]; grid: number; bytes: number },
  figures: object | null,
): string {
  return JSON.stringify(
    {
      kind: "corners and parabolas",
      name,
      about: messages.closedCurveNodeOn,
      word,
      bytes,
      grid,
      nodes,
      ...(figures ? { figures: { unit: messages.percentDiagonalOutlinesBounding, ...figures } } : {}),
    },
    null,
    1,
  );
}

/** x,y lines. */
export function pointsCsv(points: Float64Array): string {
  const lines = ["x,y"];
  for (let i = 0; i + 1 < points.length; i += 2) {
    lines.push(`${short(points[i] ?? 0)},${short(points[i + 1] ?? 0)}`);
  }
  return `${lines.join("\n")}\n`;
}
