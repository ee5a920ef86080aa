// The pictures of the plane as the processor draws them: the built module, in Node.
import { readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { pathToFileURL } from "node:url";

/** The package's module for drawing, or the bindings of another one. */
export async function load(file, query = "") {
  const engine = await import(pathToFileURL(file).href + query);
  const bytes = await readFile(join(dirname(file), "frond_bg.wasm"));
  await engine.default({ module_or_path: bytes });
  return engine;
}

/** Seconds of work cost less where they are read off the processor: what else runs on the machine is not in them. */
export function clock() {
  const { user, system } = process.cpuUsage();
  return { wall: performance.now(), cpu: (user + system) / 1000 };
}

export function quantile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? Number.NaN;
}

export const median = (numbers) => quantile(numbers, 0.5);

/** Frames that are drawn before any is measured: V8 compiles a module twice, and the second time makes it quick. */
const WARM = 12;

/** What moves: the maps of each frame, for a time from 0 to 1. */
export function pulled(maps) {
  return (t) => {
    // The first map turns to and fro by a degree and shrinks a little, as under a hand.
    const angle = (Math.PI / 180) * Math.sin(2 * Math.PI * t);
    const [cos, sin] = [Math.cos(angle) * (1 - 0.01 * t), Math.sin(angle) * (1 - 0.01 * t)];
    return maps.map(([a, b, c, d, e, f], k) =>
      k > 0
        ? [a, b, c, d, e, f]
        : [cos * a - sin * c, cos * b - sin * d, sin * a + cos * c, sin * b + cos * d, e, f],
    );
  };
}

/** A morph of two shapes of the gallery. */
export function morphed(engine, from, to) {
  const pair = engine.pair(from, to);
  return (t) => engine.interpolate({ maps: pair.from }, { maps: pair.to }, { u: t, v: t }).maps;
}

/** The fixed point of the maps one after the other, the last letter first. */
function fixedPoint(maps, word) {
  let [a, b, c, d, e, f] = [1, 0, 0, 1, 0, 0];
  for (const letter of word) {
    const [p, q, r, s, x, y] = maps[letter % maps.length];
    [a, b, c, d, e, f] = [
      a * p + b * r,
      a * q + b * s,
      c * p + d * r,
      c * q + d * s,
      a * x + b * y + e,
      c * x + d * y + f,
    ];
  }
  const determinant = (1 - a) * (1 - d) - b * c;
  return { x: ((1 - d) * e + b * f) / determinant, y: (c * e + (1 - a) * f) / determinant };
}

const WORDS = [[0, 1, 2, 3, 4, 5, 6, 7], [0, 1], [1, 0, 0], [0, 1, 1, 2], [2, 0, 1, 3, 1], [1]];

/** A window so many times as close as the one that shows all, around a point of the attractor. */
export function windowAt(engine, maps, { width, height }, zoom, word) {
  if (zoom === 1) return {};
  const { min, max } = engine.bounds({ maps });
  const whole = Math.min(width / (max[0] - min[0] || 1), height / (max[1] - min[1] || 1));
  return { view: { ...fixedPoint(maps, word), scale: whole * zoom } };
}

/** The word around whose point most is lit, in a small picture: far inside of the shape, if that has an inside. */
export function inside(engine, maps, zoom) {
  const small = { width: 60, height: 40 };
  const lit = (word) =>
    count(
      engine.rasterize({ maps }, { ...small, ...windowAt(engine, maps, small, zoom, word), draft: true }),
    );
  return WORDS.map((word) => ({ word, lit: lit(word) })).sort((p, q) => q.lit - p.lit)[0].word;
}

function count(pixels) {
  let lit = 0;
  for (let i = 3; i < pixels.length; i += 4) lit += pixels[i] > 0 ? 1 : 0;
  return lit;
}

/** Shares of the complete picture's pixels: those that the other one leaves dark, and those that it lights beside. */
export function compare(drawn, complete) {
  let [lit, missing, extra] = [0, 0, 0];
  for (let i = 3; i < complete.length; i += 4) {
    if (complete[i] > 0) lit++;
    if (complete[i] > 0 && drawn[i] === 0) missing++;
    if (complete[i] === 0 && drawn[i] > 0) extra++;
  }
  return { missing: missing / Math.max(1, lit), extra: extra / Math.max(1, lit), lit };
}

/**
 * Draws so many frames by each engine, in turn: for each one the milliseconds of a frame, by the clock and by the
 * processor. What else the machine does is then the same for all.
 */
export function measure(engines, at, options, frames) {
  const times = engines.map(() => ({ cpu: [], wall: [] }));
  for (let frame = 0; frame < frames; frame++) {
    const maps = at(frame / frames);
    const all = options(maps);
    for (const k of engines.keys()) {
      // Each begins as often as the others.
      const which = (k + frame) % engines.length;
      const start = clock();
      engines[which].rasterize({ maps }, all);
      const end = clock();
      times[which].cpu.push(end.cpu - start.cpu);
      times[which].wall.push(end.wall - start.wall);
    }
  }
  return times;
}

export function warm(engines, maps) {
  for (const engine of engines) {
    for (let k = 0; k < WARM; k++) {
      engine.rasterize({ maps }, { width: 450, height: 300, draft: true });
      engine.rasterize({ maps }, { width: 450, height: 300 });
    }
  }
}
