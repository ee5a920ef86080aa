// @ts-check
// Closed curves in wasm, at 260 numbers: a frame of a morph, of a mesh that is moved, of both, and of a view that is
// moved. Takes www/pkg as it is: `cargo xtask build` before.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import init, * as frond from "../../www/pkg/frond-curve.js";

const file = fileURLToPath(new URL("../../www/pkg/frond-curve_bg.wasm", import.meta.url));
/** @typedef {Parameters<frond.CurveMorph["polyline"]>[1]} View */

await init({ module_or_path: readFileSync(file) });

/**
 * Milliseconds: the middle and the longest of some runs, the first few left out.
 * @param {number} runs @param {(i: number) => void} run
 */
function time(runs, run) {
  /** @type {number[]} */
  const list = [];
  for (let i = 0; i < runs + 5; i++) {
    const start = performance.now();
    run(i);
    if (i >= 5) list.push(performance.now() - start);
  }
  list.sort((a, b) => a - b);
  return `${list[runs >> 1]?.toFixed(2)} ms, at most ${list[runs - 1]?.toFixed(2)}`;
}

const [maple, oak] = ["maple", "oak"].map(
  (id) => frond.curvePresets().find((preset) => preset.id === id)?.curve,
);
if (!maple || !oak) throw new Error("no such presets");
console.log(`brought to one structure: ${time(20, () => new frond.CurveMorph(maple, oak).free())}`);
const morph = new frond.CurveMorph(maple, oak);
const [left, bottom, right, top] = morph.bounds(0.5);
const size = Math.hypot(right - left, top - bottom);
const pixel = size / 1000;

/** @returns {Required<View>["bend"]} @param {number} i @param {number} ke */
const bend = (i, ke) => ({
  columns: 4,
  rows: 4,
  box: [left, bottom, right, top],
  moves: Array.from({ length: 32 }, (_, k) => 0.1 * size * Math.sin(0.01 * i + k)),
  kb: 0,
  ke,
  delta: 0.6,
  spin: "none",
  continuity: "auto",
  superposed: true,
});
let points = 0;
/** @param {number} s @param {Partial<View>} view */
const draw = (s, view) => {
  points = morph.polyline(s, { tolerance: pixel, ...view }).length / 2;
};
/** @param {string} what @param {(i: number) => void} run */
const report = (what, run) => console.log(`${what}: ${time(60, run)}; ${points} points`);

report("morph, 1 of 1000 pixels", (i) => draw(0.2 + 0.005 * i, {}));
report("a quarter of a pixel", (i) => draw(0.2 + 0.005 * i, { tolerance: pixel / 4 }));
for (const ke of [5, 7, 9]) {
  report(`mesh moved, ke ${ke}`, (i) => draw(0.5, { bend: bend(i, ke) }));
  report(`mesh and morph, ke ${ke}`, (i) => draw(0.2 + 0.005 * i, { bend: bend(i, ke) }));
}
/** @returns {[number, number, number, number]} @param {number} i */
const window = (i) => {
  const x = left + (0.4 + 0.001 * i) * (right - left);
  const y = bottom + 0.7 * (top - bottom);
  return [x, y, x + 0.01 * size, y + 0.01 * size];
};
report("view moved, 100 times", (i) => draw(0.5, { tolerance: pixel / 100, window: window(i) }));
report("the same, bent, ke 7", (i) =>
  draw(0.5, { tolerance: pixel / 100, window: window(i), bend: bend(0, 7) }),
);
