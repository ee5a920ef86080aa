/** A shape in the making: a rectangle, its copies under all maps, their copies, and so on. */
import { boxOf, fitFor } from "#document/framing";
import type { Box } from "#geometry/boxes";
import { isDark } from "#style/ground";
import { palette } from "#style/palette";
import type { MapRow } from "#wasm/api";
import type { Drawer, FrameLook, FramePixels } from "#workers/film/subject";
import type { FilmSubject } from "./subject";

/** Copies at most in a frame. */
const MOST_COPIES = 60_000;
const MOST_STEPS = 14;
/** Copies smaller than this part of the first figure are dots: further steps show nothing new. */
const DOT = 1 / 1500;
/** Free on each side, as a part of it. */
const MARGIN = 0.08;

interface Copy {
  map: MapRow;
  /** The map that made it last: its colour. */
  by: number;
}

/** The copies after each step; after none there is the figure itself. */
export function stepsOf(maps: readonly MapRow[]): Copy[][] {
  const steps: Copy[][] = [[{ map: [1, 0, 0, 1, 0, 0], by: 0 }]];
  for (;;) {
    const last = steps.at(-1) ?? [];
    const seen = last.some(({ map: [a, b, c, d] }) => Math.hypot(a, b, c, d) > DOT);
    const copies = last.length * maps.length;
    if (!seen || steps.length > MOST_STEPS || copies > MOST_COPIES || copies === 0) return steps;
    steps.push(maps.flatMap((map, by) => last.map((copy) => ({ map: composed(map, copy.map), by }))));
  }
}

/** First `inner`, then `outer`. */
function composed([a, b, c, d, e, f]: MapRow, [p, q, r, s, t, u]: MapRow): MapRow {
  return [a * p + b * r, a * q + b * s, c * p + d * r, c * q + d * s, a * t + b * u + e, c * t + d * u + f];
}

/** Each step stands for a second. Null where there is no attractor. */
export function stepsSubject(maps: MapRow[], name: string, ground: string): FilmSubject | null {
  const box = boxOf(maps);
  if (!box || maps.length === 0) return null;
  const steps = stepsOf(maps);
  return {
    id: "steps",
    label: "Step by step",
    name: `${name}-steps`,
    seconds: steps.length,
    anyLength: true,
    loops: ["once", "pingpong"],
    loop: "once",
    ground,
    choosesSmooth: false,
    drawer: (look) => stepsDrawer(look, steps, box),
  };
}

function stepsDrawer(look: FrameLook, steps: readonly Copy[][], box: Box): Drawer {
  let shown = -1;
  return {
    hands: 1,
    missing: 0,
    async frame(seconds, signal) {
      const step = Math.min(steps.length - 1, Math.max(0, Math.floor(seconds)));
      if (step === shown) return null;
      shown = step;
      // The page has its turn between two frames.
      await new Promise((resolve) => setTimeout(resolve));
      signal.throwIfAborted();
      return drawn(look, steps[step] ?? [], box, steps);
    },
    end() {},
  };
}

function drawn(
  { width, height, ground }: FrameLook,
  copies: readonly Copy[],
  box: Box,
  steps: readonly Copy[][],
): FramePixels {
  const began = performance.now();
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("This browser has no canvas to draw on.");
  const colours = palette(isDark(ground) ? "dark" : "light");
  const { x, y, scale } = fitFor(seenBox(steps, box), { width, height }, MARGIN);
  const paths = new Map<number, Path2D>();
  for (const { map, by } of copies) {
    const path = paths.get(by) ?? new Path2D();
    paths.set(by, path);
    for (const [i, [px, py]] of cornersOf(map, box).entries()) {
      const [across, down] = [width / 2 + (px - x) * scale, height / 2 - (py - y) * scale];
      if (i === 0) path.moveTo(across, down);
      else path.lineTo(across, down);
    }
    path.closePath();
  }
  // Thin copies are to be seen, too.
  context.lineWidth = Math.max(0.75, Math.min(width, height) / 900);
  context.lineJoin = "round";
  for (const [by, path] of [...paths].sort(([p], [q]) => p - q)) {
    const colour = colours[by % colours.length] ?? "";
    context.fillStyle = colour;
    context.strokeStyle = colour;
    context.globalAlpha = copies.length === 1 ? 0.8 : 0.9;
    context.fill(path);
    context.stroke(path);
  }
  const { data } = context.getImageData(0, 0, width, height);
  return { width, height, data: data as Uint8ClampedArray<ArrayBuffer>, took: performance.now() - began };
}

const cornersOf = ([a, b, c, d, e, f]: MapRow, { x0, y0, x1, y1 }: Box): [number, number][] =>
  (
    [
      [x0, y0],
      [x1, y0],
      [x1, y1],
      [x0, y1],
    ] as const
  ).map(([x, y]) => [a * x + b * y + e, c * x + d * y + f]);

/** All that is to be seen in any of the first steps: copies may stand out from the figure. */
function seenBox(steps: readonly Copy[][], box: Box): Box {
  const corners = steps.slice(0, 3).flatMap((copies) => copies.flatMap(({ map }) => cornersOf(map, box)));
  const [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
  return { x0: Math.min(...xs), y0: Math.min(...ys), x1: Math.max(...xs), y1: Math.max(...ys) };
}
