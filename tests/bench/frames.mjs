// How long a picture of the plane takes: of every shape of the gallery by the processor, in Node, and in the page, on
// each backend, while the time of a morph is scrubbed. LOG.md beside this file says what the numbers are, and keeps
// those of every experiment.
//
// FROND_MODULE and FROND_AGAINST are bindings (frond.js): with the second, both draw the same frames in turn, and what
// is told is how the first compares. With one module as both, that is how far two measurements of one thing differ.
// FROND_SHAPES, as `dragon,fern`, draws these alone. Without FROND_URL the page is left out.
import { fileURLToPath } from "node:url";
import { load } from "./frames/engine.mjs";
import { against, frames, summary } from "./frames/tables.mjs";

const built = fileURLToPath(new URL("../../www/pkg/frond.js", import.meta.url));
const module = process.env["FROND_MODULE"] ?? built;
const other = process.env["FROND_AGAINST"];
const engine = await load(module);
const wanted = process.env["FROND_SHAPES"]?.split(",");
const shapes = engine.presets().filter(({ id }) => wanted?.includes(id) ?? true);
if (shapes.length === 0) throw new Error(`There is no shape ${process.env["FROND_SHAPES"]} in the gallery.`);

if (other) {
  // The same file twice is two modules where their addresses differ.
  against(engine, await load(other, "?other"), shapes);
} else {
  const told = frames(engine, shapes);
  const address = process.env["FROND_URL"];
  if (address) await (await import("./frames/page.mjs")).scrub(address);
  console.log(summary(told));
}
