/** A shape in the making: a figure, its copies under all maps, their copies, and so on. */
import { boxOf, fitFor } from "#document/framing";
import { shownColours } from "#document/morph";
import type { Box } from "#geometry/boxes";
import { after2 } from "#geometry/maps/affine2";
import { isDark } from "#style/ground";
import type { MapRow } from "#wasm/api";
import { frond } from "#wasm/core";
import type { Drawer, FrameLook, FramePixels } from "#workers/film/subject";
import { turn } from "#workers/film/turn";
import * as messages from "./messages";
import { SEEDS, type SeedName, seedCorners } from "./seed";
import type { FilmSubject } from "./subject";

/** Copies at most in a frame. */
const MOST_COPIES = 60_000;
const MOST_STEPS = 14;
/** Copies smaller than this part of the first figure are dots: further steps show nothing new. */
const DOT = 1 / 1500;
/** Of the mark for a point, as a part of the shorter side of a frame. */
const DOT_RADIUS = 1 / 500;
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
    steps.push(maps.flatMap((map, by) => last.map((copy) => ({ map: after2(map, copy.map), by }))));
  }
}

type Corners = ReturnType<typeof seedCorners>;

/** Each step stands for a second. Null where there is no attractor. */
export function stepsSubject(
  maps: MapRow[],
  name: string,
  ground: string,
  seed: SeedName = "frame",
): FilmSubject | null {
  const box = boxOf(maps);
  if (!box || maps.length === 0) return null;
  const steps = stepsOf(maps);
  // Those of now: a film goes on while somebody chooses others.
  const colours = { light: shownColours("light"), dark: shownColours("dark") };
  const corners = seedCorners(seed, box, frond.bounds({ maps }).hull);
  const figure = { corners, seen: seenBox(steps, corners, box), colours };
  return {
    id: "steps",
    label: messages.stepByStep,
    name: `${name}-steps`,
    seconds: steps.length,
    anyLength: true,
    loops: ["once", "pingpong"],
    loop: "once",
    easing: null,
    ground,
    choosesSmooth: false,
    seeds: {
      options: SEEDS,
      value: seed,
      begin: (other) => stepsSubject(maps, name, ground, other),
    },
    drawer: (look) => stepsDrawer(look, steps, figure),
  };
}

/** What is copied, what of the plane is seen, and in which colours. */
interface Figure {
  corners: Corners;
  seen: Box;
  colours: Record<"light" | "dark", readonly string[]>;
}

function stepsDrawer(look: FrameLook, steps: readonly Copy[][], figure: Figure): Drawer {
  let shown = -1;
  return {
    hands: 1,
    missing: 0,
    async frame(seconds, signal) {
      const step = Math.min(steps.length - 1, Math.max(0, Math.floor(seconds)));
      if (step === shown) return null;
      shown = step;
      // The page has its turn between two frames.
      await turn();
      signal.throwIfAborted();
      return drawn(look, steps[step] ?? [], figure);
    },
    end() {},
  };
}

function drawn(
  { width, height, ground }: FrameLook,
  copies: readonly Copy[],
  { corners, seen, colours: both }: Figure,
): FramePixels {
  const began = performance.now();
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error(messages.thisBrowserCouldNot);
  const colours = both[isDark(ground) ? "dark" : "light"];
  const { x, y, scale } = fitFor(seen, { width, height }, MARGIN);
  const dot = Math.max(1, DOT_RADIUS * Math.min(width, height));
  const paths = new Map<number, Path2D>();
  for (const { map, by } of copies) {
    const path = paths.get(by) ?? new Path2D();
    paths.set(by, path);
    for (const [i, [px, py]] of imageOf(map, corners).entries()) {
      const [across, down] = [width / 2 + (px - x) * scale, height / 2 - (py - y) * scale];
      if (corners.length === 1) path.rect(across - dot, down - dot, 2 * dot, 2 * dot);
      else if (i === 0) path.moveTo(across, down);
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

const imageOf = ([a, b, c, d, e, f]: MapRow, corners: Corners): [number, number][] =>
  corners.map(([x, y]) => [a * x + b * y + e, c * x + d * y + f]);

/** The attractor, and all that is to be seen in any of the first steps: copies may stand out from the figure. */
export function seenBox(steps: readonly Copy[][], corners: Corners, attractor: Box): Box {
  const box = { ...attractor };
  for (const { map } of steps.slice(0, 3).flat()) {
    for (const [x, y] of imageOf(map, corners)) {
      box.x0 = Math.min(box.x0, x);
      box.y0 = Math.min(box.y0, y);
      box.x1 = Math.max(box.x1, x);
      box.y1 = Math.max(box.y1, y);
    }
  }
  return box;
}
