/** What proves a verdict, as a drawing: the shape in pieces, and over it what holds them together or apart. */
import { after2, imageOf } from "#geometry/maps/affine2";
import { BAD, BLACK, GREY, INK, WHITE } from "#style/colours";
import { escaped, rounded, svgFile, tag } from "#ui/files/svg";
import type { Link, MapRow } from "#wasm/api";
import * as messages from "./messages";

type Point = readonly [number, number];

export interface Evidence {
  title: string;
  /** What is known, in sentences. */
  words: string;
  maps: readonly MapRow[];
  /** A convex polygon around the shape. */
  hull: readonly Point[];
  colours: readonly string[];
  links: readonly Link[];
  /** Pieces that a proof keeps apart, on two sides. */
  sides: readonly { side: 0 | 1; corners: readonly Point[] }[];
  gap: { from: Point; to: Point; words: string } | null;
}

/** The most pieces of a drawing, and the size below which none is taken apart, as a part of the whole. */
const MOST_PIECES = 3000;
const FINE = 1 / 700;
/** Corners of the outline of a piece; in so small a thing more are not seen. */
const MOST_CORNERS = 12;
const SIDE = 900;
const MARGIN = 30;
const RING = 7;

const tenth = (x: number) => Math.round(10 * x) / 10;

export function evidenceDrawing(evidence: Evidence): string {
  const { title, words, maps, hull, colours, links, sides, gap } = evidence;
  const xs = hull.map(([x]) => x);
  const ys = hull.map(([, y]) => y);
  const [left, top] = [Math.min(...xs), Math.max(...ys)];
  const [across, down] = [Math.max(...xs) - left, top - Math.min(...ys)];
  const scale = SIDE / Math.max(across, down, 1e-300);
  const at = ([x, y]: Point): Point => [
    tenth(MARGIN + (x - left) * scale),
    tenth(MARGIN + (top - y) * scale),
  ];
  const area = (corners: readonly Point[]) => `M${corners.map((corner) => at(corner).join(" ")).join("L")}Z`;
  const colourOf = (map: number) => colours[map % colours.length] ?? GREY;

  const few = Math.max(1, hull.length / MOST_CORNERS);
  const outline = hull.filter((_, i) => Math.floor(i / few) !== Math.floor((i - 1) / few));
  const pieces = piecesOf(maps, hull, Math.max(across, down));
  const shape = maps.map((_, first) => {
    const own = pieces.filter((piece) => piece.first === first);
    const d = own.map(({ map }) => area(outline.map((corner) => imageOf(map, corner)))).join("");
    return tag("path", { fill: colourOf(first), stroke: colourOf(first), d });
  });
  const parts = [
    tag("g", { "stroke-width": 0.4, "stroke-linejoin": "round" }, ...shape),
    ...sides.map(({ side, corners }) =>
      tag("path", {
        d: area(corners),
        fill: INK,
        "fill-opacity": 0.05,
        stroke: INK,
        ...(side === 1 ? { "stroke-dasharray": "3 3" } : {}),
      }),
    ),
    ...links.flatMap((link) => linkOf(link, at, colourOf)),
    ...(gap ? gapOf(gap, at) : []),
  ];
  const box = [0, 0, across * scale + 2 * MARGIN, down * scale + 2 * MARGIN] as const;
  const count = messages.piecesDrawn(pieces.length);
  const about = messages.drawingAbout(words, count);
  return svgFile({ box, title, about }, ...parts);
}

interface Piece {
  map: MapRow;
  first: number;
}

/** The shape cut into pieces until all are small, or there are as many as a drawing may have. */
function piecesOf(maps: readonly MapRow[], hull: readonly Point[], whole: number): Piece[] {
  const sizeOf = (map: MapRow) => {
    const images = hull.map((corner) => imageOf(map, corner));
    const [xs, ys] = [images.map(([x]) => x), images.map(([, y]) => y)];
    return Math.max(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys));
  };
  const sized = (piece: Piece) => ({ ...piece, size: sizeOf(piece.map) });
  let pieces = maps.map((map, first) => sized({ map, first }));
  // All that are above a size at once, which halves; so pieces stay of about one size.
  for (let least = whole / 2; least > FINE * whole; least /= 2) {
    for (;;) {
      const large = pieces.filter(({ size }) => size > least);
      if (large.length === 0) break;
      const more = pieces.length + large.length * (maps.length - 1);
      // One map alone makes no more pieces, only smaller ones.
      if (more > MOST_PIECES || maps.length < 2) return pieces;
      const smaller = large.flatMap(({ map, first }) =>
        maps.map((inner) => sized({ map: after2(map, inner), first })),
      );
      pieces = [...pieces.filter(({ size }) => size <= least), ...smaller];
    }
  }
  return pieces;
}

function line(from: Point, to: Point, colour: string): string[] {
  const d = `M${from.join(" ")}L${to.join(" ")}`;
  return [
    tag("path", { d, fill: "none", stroke: WHITE, "stroke-width": 6, "stroke-opacity": 0.8 }),
    tag("path", { d, fill: "none", stroke: colour, "stroke-width": 2.5 }),
  ];
}

/** Two chords that cross, or a ring around a point that two pieces share. */
function linkOf(
  { at: middle, corners, pair }: Link,
  at: (p: Point) => Point,
  colourOf: (map: number) => string,
) {
  const [p1, p2, q1, q2] = corners ?? [];
  if (p1 && p2 && q1 && q2) {
    // Of one colour: pieces below have theirs.
    const chords = [...line(at(p1), at(p2), BLACK), ...line(at(q1), at(q2), BLACK)];
    const ends = [p1, p2, q1, q2].map((end, k) => {
      const [cx, cy] = at(end);
      return tag("circle", { cx, cy, r: 3, fill: colourOf(pair[k < 2 ? 0 : 1]), stroke: BLACK });
    });
    return [...chords, ...ends];
  }
  const [cx, cy] = at(middle);
  const ring = { cx, cy, r: RING, fill: "none" };
  return [
    tag("circle", { ...ring, stroke: WHITE, "stroke-width": 6, "stroke-opacity": 0.8 }),
    tag("circle", { ...ring, stroke: BLACK, "stroke-width": 2 }),
  ];
}

function gapOf({ from, to, words }: NonNullable<Evidence["gap"]>, at: (p: Point) => Point): string[] {
  const [p, q] = [at(from), at(to)];
  const [x, y] = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
  const r = rounded(Math.max(9, Math.hypot(q[0] - p[0], q[1] - p[1]) / 2 + 6));
  const letters = { x: rounded(x + r + 6), y: rounded(y + 5), "font-family": "sans-serif", "font-size": 16 };
  return [
    ...line(p, q, BAD),
    tag("circle", {
      cx: rounded(x),
      cy: rounded(y),
      r,
      fill: "none",
      stroke: BAD,
      "stroke-width": 1.5,
      "stroke-dasharray": "3 3",
    }),
    tag("text", { ...letters, stroke: WHITE, "stroke-width": 4, "stroke-linejoin": "round" }, escaped(words)),
    tag("text", { ...letters, fill: BAD }, escaped(words)),
  ];
}
