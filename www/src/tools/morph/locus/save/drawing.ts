/** The map as a drawing: areas of one answer, axes with numbers, and the path. Pure, for the tests. */

import { fixed } from "#format/numbers";
import { STATE } from "#geometry/states";
import type { LocusStyle } from "#stage/locus/paint";
import { BAD, INK, WHITE } from "#style/colours";
import {
  BROKEN,
  HIDDEN,
  HIDDEN_STRIPE,
  HOLDS,
  NONE,
  type Rgb,
  ramp,
  shadeOf,
  TOUCHES,
  TOUCHES_DOT,
  UNDECIDED,
} from "#style/ramp";
import { escaped, rounded, svgFile, svgPen, tag } from "#ui/files/svg";
import type { Bounds, Locus } from "#wasm/api";
import * as messages from "../messages";
import { ticksOf } from "../view/geometry";

// Outlines of areas of equal samples.

/** Right, down, left, up. */
const STEPS = [
  [1, 0],
  [0, 1],
  [-1, 0],
  [0, -1],
] as const;

/**
 * The outline of each class of cells of a grid, as closed polygons of cell corners, to be filled even-odd: x, y, x, y,
 * .. with a corner where they turn. They meet without a gap.
 */
export function outlinesOf(
  classes: ArrayLike<number>,
  width: number,
  height: number,
): Map<number, number[][]> {
  const found = new Map<number, number[][]>();
  const row = width + 1;
  for (const one of new Set(Array.from(classes))) {
    // At each corner, the steps that leave it with the class on the right hand: a bit each.
    const leave = new Uint8Array(row * (height + 1));
    const is = (x: number, y: number) =>
      x >= 0 && y >= 0 && x < width && y < height && classes[y * width + x] === one;
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        if (!is(x, y)) continue;
        const at = y * row + x;
        if (!is(x, y - 1)) leave[at] = (leave[at] ?? 0) | 1;
        if (!is(x + 1, y)) leave[at + 1] = (leave[at + 1] ?? 0) | 2;
        if (!is(x, y + 1)) leave[at + row + 1] = (leave[at + row + 1] ?? 0) | 4;
        if (!is(x - 1, y)) leave[at + row] = (leave[at + row] ?? 0) | 8;
      }
    }
    const polygons: number[][] = [];
    for (let start = 0; start < leave.length; start++) {
      while (leave[start]) polygons.push(walk(leave, start, row));
    }
    found.set(one, polygons);
  }
  return found;
}

/** Once round, from a corner back to it; the steps are taken away. */
function walk(leave: Uint8Array, start: number, row: number): number[] {
  const corners: number[] = [];
  let [at, before] = [start, -1];
  do {
    const open = leave[at] ?? 0;
    const step = [0, 1, 2, 3].find((k) => open & (1 << k)) ?? 0;
    leave[at] = open & ~(1 << step);
    if (step !== before) corners.push(at % row, Math.floor(at / row));
    before = step;
    const [dx, dy] = STEPS[step] ?? [0, 0];
    at += dx + dy * row;
  } while (at !== start);
  return corners;
}

/** Room for numbers and names, in pixels. */
export const MARGIN = { left: 170, right: 40, top: 40, bottom: 140 };

const TICK = 14;
const FONT = "36px system-ui, sans-serif";

/** What of a canvas is used. */
type Pen = Pick<
  CanvasRenderingContext2D,
  | "fillRect"
  | "strokeRect"
  | "fillText"
  | "beginPath"
  | "moveTo"
  | "lineTo"
  | "stroke"
  | "fillStyle"
  | "strokeStyle"
  | "lineWidth"
  | "font"
  | "textAlign"
  | "textBaseline"
>;

/** A frame around a square picture, with numbers and names, on white: for papers. */
export function drawAxes(
  pen: Pen,
  size: number,
  { u0, u1, v0, v1 }: Bounds,
  names: { across: string; up: string },
  drawSquare: () => void,
): void {
  const { left, top } = MARGIN;
  const bottom = top + size;
  pen.fillStyle = WHITE;
  pen.fillRect(0, 0, size + left + MARGIN.right, size + top + MARGIN.bottom);
  drawSquare();
  pen.strokeStyle = INK;
  pen.fillStyle = INK;
  pen.lineWidth = 3;
  pen.font = FONT;
  pen.strokeRect(left, top, size, size);
  const tick = (x: number, y: number, dx: number, dy: number) => {
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(x + dx, y + dy);
    pen.stroke();
  };
  pen.textAlign = "center";
  pen.textBaseline = "top";
  const across = ticksOf(u0, u1);
  for (const value of across.at) {
    const x = left + (size * (value - u0)) / (u1 - u0);
    tick(x, bottom, 0, TICK);
    pen.fillText(fixed(value, across.digits), x, bottom + TICK + 8);
  }
  pen.fillText(names.across, left + size / 2, bottom + 78);
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  const up = ticksOf(v0, v1);
  for (const value of up.at) {
    const y = bottom - (size * (value - v0)) / (v1 - v0);
    tick(left, y, -TICK, 0);
    pen.fillText(fixed(value, up.digits), left - TICK - 8, y);
  }
  pen.textAlign = "left";
  pen.fillText(names.up, 14, top + size / 2);
}

interface MapDrawing {
  title: string;
  /** What the axes show. */
  window: Bounds;
  names: { across: string; up: string };
  /** The samples; without them there is the path alone. */
  areas?: { field: Locus & { bounds: Bounds }; style: LocusStyle; epsilon: number };
  /** Of the path, in hundredths of the square: as SVG writes paths; faint is what lies off the slice. */
  path?: { whole: string; broken: string; faint: string; faintBroken: string };
  ends?: readonly { letter: string; at: readonly [number, number] }[];
}

/** A side of the square: its axes are made for that. */
const SIDE = 1600;

/** Shades of broken areas: so many steps of the gap, by its logarithm. */
const SHADES = 8;
/** Classes of cells beyond the states. */
const SHADE = 16;

const rgb = ([r, g, b]: Rgb): string => `#${[r, g, b].map((x) => x.toString(16).padStart(2, "0")).join("")}`;

interface Look {
  words: string;
  fill: string;
  /** A pattern over it, so that colour is not the only sign. */
  over?: "dots" | "stripes" | "cross" | "specks";
}

const LOOKS: Readonly<Record<number, Look>> = {
  [STATE.connected]: { words: messages.inOnePieceProved, fill: rgb(HOLDS) },
  [STATE.touching]: { words: messages.noGapSeenAt, fill: rgb(TOUCHES), over: "dots" },
  [STATE.hidden]: { words: messages.inPiecesByGap, fill: rgb(HIDDEN), over: "stripes" },
  [STATE.undecided]: { words: messages.notDecided, fill: rgb(UNDECIDED), over: "specks" },
  [STATE.none]: { words: messages.noAttractor, fill: rgb(NONE), over: "cross" },
  [STATE.disconnected]: { words: messages.inPiecesByFronds, fill: rgb(BROKEN) },
};

const PATTERNS = [
  tag(
    "pattern",
    { id: "dots", width: 32, height: 32, patternUnits: "userSpaceOnUse" },
    tag("circle", { cx: 8, cy: 8, r: 2.5, fill: rgb(TOUCHES_DOT) }),
    tag("circle", { cx: 24, cy: 24, r: 2.5, fill: rgb(TOUCHES_DOT) }),
  ),
  tag(
    "pattern",
    { id: "stripes", width: 24, height: 24, patternUnits: "userSpaceOnUse" },
    tag("path", { d: "M-6 6L6 -6M0 24L24 0M18 30L30 18", stroke: rgb(HIDDEN_STRIPE), "stroke-width": 5 }),
  ),
  tag(
    "pattern",
    { id: "cross", width: 16, height: 16, patternUnits: "userSpaceOnUse" },
    tag("path", { d: "M0 0L16 16M0 16L16 0", stroke: rgb(UNDECIDED), "stroke-width": 1.5 }),
  ),
  tag(
    "pattern",
    { id: "specks", width: 16, height: 16, patternUnits: "userSpaceOnUse" },
    tag("rect", { width: 5, height: 5, fill: rgb(NONE) }),
  ),
];

/** The text of the file. */
export function mapDrawing({ title, window, names, areas, path, ends = [] }: MapDrawing): string {
  const pen = svgPen();
  const drawn = areas ? areasOf(areas, window) : [];
  drawAxes(pen, SIDE, window, names, () => {
    const { left, top } = MARGIN;
    const square = { x: left, y: top, width: SIDE, height: SIDE };
    // What lies beyond the square is cut off by being in a drawing of its own.
    if (drawn.length > 0) pen.parts.push(tag("svg", { ...square, viewBox: `0 0 ${SIDE} ${SIDE}` }, ...drawn));
    if (path) pen.parts.push(tag("svg", { ...square, viewBox: "0 0 100 100" }, ...pathOf(path)));
  });
  for (const { letter, at } of ends) pen.parts.push(endOf(letter, at));
  const said = [
    areas ? messages.areas(drawn.length) : "",
    path ? messages.path : "",
    messages.axesFromTo(names.across, window.u0, window.u1, names.up, window.v0, window.v1),
  ];
  return svgFile(
    {
      box: [0, 0, SIDE + MARGIN.left + MARGIN.right, SIDE + MARGIN.top + MARGIN.bottom],
      title,
      about: messages.madeBy(said.filter(Boolean).join(", ")),
    },
    ...(areas ? [tag("defs", {}, ...PATTERNS)] : []),
    ...pen.parts,
  );
}

/** A path for each answer, and for each shade of a gap: of samples, each of which stands for what is nearest to it. */
function areasOf({ field, style, epsilon }: NonNullable<MapDrawing["areas"]>, window: Bounds): string[] {
  const { width, height, state, gap, bounds } = field;
  const classes = state.map((one, i) =>
    one === STATE.disconnected && style === "gap"
      ? SHADE + Math.min(SHADES - 1, Math.floor(SHADES * shadeOf(gap[i] ?? 0, epsilon)))
      : one,
  );
  const across = placing(width, bounds.u0, bounds.u1, window.u0, window.u1);
  const up = placing(height, bounds.v0, bounds.v1, window.v0, window.v1);
  return [...outlinesOf(classes, width, height)]
    .sort(([p], [q]) => p - q)
    .flatMap(([one, polygons]) => {
      const look = lookOf(one);
      if (!look) return [];
      const d = polygons
        .map((corners) => {
          let text = "";
          for (let i = 0; i < corners.length; i += 2) {
            text += `${i === 0 ? "M" : "L"}${across(corners[i] ?? 0)} ${rounded(SIDE - up(corners[i + 1] ?? 0))}`;
          }
          return `${text}Z`;
        })
        .join("");
      const over = look.over ? [tag("path", { d, "fill-rule": "evenodd", fill: `url(#${look.over})` })] : [];
      return [
        tag(
          "g",
          {},
          tag("title", {}, escaped(look.words)),
          tag("path", { d, "fill-rule": "evenodd", fill: look.fill, "shape-rendering": "crispEdges" }),
          ...over,
        ),
      ];
    });
}

function lookOf(one: number): Look | undefined {
  if (one < SHADE || one >= SHADE + SHADES) return LOOKS[one];
  return { words: messages.inPiecesByFronds, fill: rgb(ramp((one - SHADE + 0.5) / SHADES)) };
}

/** Where the corner of a cell lies on the square: samples are in the middle of cells, the outermost on its edges. */
function placing(count: number, low: number, high: number, from: number, to: number) {
  const step = (high - low) / Math.max(1, count - 1);
  return (corner: number) => rounded((SIDE * (low + (corner - 0.5) * step - from)) / (to - from));
}

/** Light around dark, so that it is seen on any ground; dashed where it is broken. */
function pathOf({ whole, broken, faint, faintBroken }: NonNullable<MapDrawing["path"]>): string[] {
  const line = (d: string, dashed: boolean, opacity?: number) => {
    if (d === "") return [];
    const both = { d, fill: "none", "stroke-linejoin": "round", "stroke-linecap": "round", opacity };
    const dashes = dashed ? { "stroke-dasharray": "1.2 1.4" } : {};
    return [
      tag("path", { ...both, stroke: WHITE, "stroke-width": 1.1 }),
      tag("path", { ...both, stroke: dashed ? BAD : INK, "stroke-width": 0.5, ...dashes }),
    ];
  };
  return [
    ...line(faint, false, 0.4),
    ...line(faintBroken, true, 0.4),
    ...line(whole, false),
    ...line(broken, true),
  ];
}

/** A letter in a disc, where the path begins and ends. */
function endOf(letter: string, [x, y]: readonly [number, number]): string {
  const [cx, cy] = [rounded(MARGIN.left + SIDE * x), rounded(MARGIN.top + SIDE * y)];
  const words = { x: cx, y: cy, dy: "0.35em", "text-anchor": "middle", "font-family": "sans-serif" };
  return tag(
    "g",
    {},
    tag("circle", { cx, cy, r: 20, fill: WHITE, stroke: INK, "stroke-width": 3 }),
    tag("text", { ...words, "font-size": 26, "font-weight": 600, fill: INK }, escaped(letter)),
  );
}
