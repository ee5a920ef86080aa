/** Closed curves as the text of files. */
import { plainName } from "#ui/files/download";
import { rounded, svgFile, tag } from "#ui/files/svg";
import type { Bend, CurveShape } from "#wasm/api";
import type { CurveMap } from "#wasm/curve";
import * as messages from "./messages";

interface Both {
  a: CurveShape;
  b: CurveShape;
}

/** Coordinates in a drawing go to a hundred-thousandth of its size. */
const SIDE = 1000;
const EDGE = 20;

/** The outline as a drawing a thousand units long, y down as drawings have it. */
export function svgOf(
  points: ArrayLike<number>,
  { title, colour }: { title: string; colour: string },
): string {
  const [x0, y0, x1, y1] = boxOf(points);
  const size = Math.max(x1 - x0, y1 - y0);
  const scale = size > 0 ? SIDE / size : 0;
  const place = (i: number) =>
    `${rounded(EDGE + ((points[i] ?? 0) - x0) * scale)} ${rounded(EDGE + (y1 - (points[i + 1] ?? 0)) * scale)}`;
  let path = "";
  for (let i = 0; i + 1 < points.length; i += 2) path += `${i === 0 ? "M" : "L"}${place(i)}`;
  const width = rounded((x1 - x0) * scale + 2 * EDGE);
  const height = rounded((y1 - y0) * scale + 2 * EDGE);
  return svgFile(
    { box: [0, 0, width, height], title },
    tag("path", {
      d: `${path}Z`,
      fill: colour,
      "fill-opacity": 0.15,
      stroke: colour,
      "stroke-width": 2,
      "stroke-linejoin": "round",
    }),
  );
}

function boxOf(points: ArrayLike<number>): [number, number, number, number] {
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i + 1 < points.length; i += 2) {
    const [x, y] = [points[i] ?? 0, points[i + 1] ?? 0];
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x);
    box[3] = Math.max(box[3], y);
  }
  return points.length < 2 ? [0, 0, 0, 0] : box;
}

/** One point a line; the last one goes on to the first. */
export function csvOf(points: ArrayLike<number>): string {
  let lines = "x,y\n";
  for (let i = 0; i + 1 < points.length; i += 2) lines += `${short(points[i])},${short(points[i + 1])}\n`;
  return lines;
}

/** Seven figures: far finer than the points are apart. */
function short(x = 0): number {
  return Number(x.toPrecision(7));
}

/** Both curves with the maps that make their edges, the moment, what bends it, and the outline of the moment. */
export function jsonOf(what: {
  curves: Both;
  maps: { a: CurveMap[]; b: CurveMap[] };
  s: number;
  bend: Bend | null;
  points: ArrayLike<number>;
}): string {
  const { curves, maps, s, bend, points } = what;
  const end = ({ name, curve }: CurveShape, rows: CurveMap[]) => ({
    name,
    knots: curve.knots,
    edges: curve.edges.map((edge, i) => edge && { ...edge, map: rows[i]?.map ?? null }),
  });
  const outline = Array.from({ length: points.length / 2 }, (_, i) => [
    short(points[2 * i]),
    short(points[2 * i + 1]),
  ]);
  const document = {
    about: messages.closedCurveByFrond,
    s,
    a: end(curves.a, maps.a),
    b: end(curves.b, maps.b),
    ...(bend ? { bend } : {}),
    outline,
  };
  return `${JSON.stringify(document)}\n`;
}

/** A file's name, of what it shows. */
export function nameOf(curves: Both | null, s: number, kind: string): string {
  const plain = (name = "") => plainName(name, "curve", 24);
  const [a, b] = [plain(curves?.a.name), plain(curves?.b.name)];
  const what = s === 0 || a === b ? a : s === 1 ? b : `${a}-${b}-${s.toFixed(2)}`;
  return `frond-${what}.${kind}`;
}
