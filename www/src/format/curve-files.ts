/** Closed curves as text. */
import type { Curve } from "#wasm/api";
import type { CurveMap } from "#wasm/curve";

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
      about:
        "Edge i runs from knot i to the next. It is straight (null), or a copy of the arc over `span` edges from knot `from`: map is [a, b, c, d, e, f], x' = a x + b y + e, y' = c x + d y + f. Indices count from 0, y points up.",
      knots,
      edges: edges.map((edge, i) => (edge ? { ...edge, map: maps[i]?.map?.map(short) ?? null } : null)),
      ...(figures ? { figures: { unit: "percent of the diagonal of the outline's box", ...figures } } : {}),
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
      about:
        "A closed curve. A node that is `on` it is a corner; any other is the middle control point of a parabola (a quadratic Bézier segment). Two of these side by side have a joint halfway. `word` is all of it in base 64 (URL-safe): it takes so many `bytes`. y points up.",
      word,
      bytes,
      grid,
      nodes,
      ...(figures ? { figures: { unit: "percent of the diagonal of the outline's box", ...figures } } : {}),
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
