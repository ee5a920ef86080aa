// What is drawn, and how it is told.
import { compare, inside, measure, median, morphed, pulled, quantile, warm, windowAt } from "./engine.mjs";

const SIZES = [
  { width: 900, height: 600 },
  { width: 450, height: 300 },
  { width: 1440, height: 900 },
];
const ZOOMS = [1, 1e2, 1e6, 1e9];
/** Frames that are drawn of a shape: of what moves, and complete. Fewer of what the last line does not tell of. */
const FRAMES = { told: [24, 5], other: [8, 2] };
/** Morphs of two shapes of the gallery, from one end to the other. */
const MORPHS = [
  ["dragon", "gasket"],
  ["fern", "tree"],
  ["carpet", "koch"],
  ["levy", "dragon"],
];

const ms = (number) => `${number < 10 ? number.toFixed(1) : number.toFixed(0)}`.padStart(6);
const percent = (share) => `${(100 * share).toFixed(2)}%`.padStart(8);
const close = (zoom) => `x${zoom < 1e3 ? zoom : `10^${Math.log10(zoom)}`}`;

/** One subject at one size and zoom: the times of drafts and of complete pictures, and how far these differ. */
function subject(engine, at, size, zoom, [drafts, completes]) {
  const word = zoom === 1 ? [] : inside(engine, at(0), zoom);
  const options = (maps) => ({ ...size, ...windowAt(engine, maps, size, zoom, word) });
  const [draft] = measure([engine], at, (maps) => ({ ...options(maps), draft: true }), drafts);
  const [complete] = measure([engine], at, options, completes);
  const maps = at(0.3);
  const all = options(maps);
  const picture = engine.rasterize({ maps }, all);
  return { draft, complete, ...compare(engine.rasterize({ maps }, { ...all, draft: true }), picture) };
}

function row(name, { draft, complete, missing, extra }) {
  const of = (times) => `${ms(median(times.cpu))}${ms(quantile(times.cpu, 0.99))}${ms(median(times.wall))}`;
  return `  ${name.padEnd(20)}${of(draft)} |${of(complete)} |${percent(missing)}${percent(extra)}`;
}

const HEAD = `  ${"".padEnd(20)}  draft p99  wall |  full p99  wall |   holes   extra`;

/** Every shape at every size, and closer. Returns what the last line tells. */
export function frames(engine, shapes) {
  warm([engine], shapes[0].maps);
  let told = null;
  for (const size of SIZES) {
    for (const zoom of ZOOMS) {
      // Close views at one size are enough.
      if (zoom > 1 && size !== SIZES[0]) continue;
      const count = zoom === 1 && size === SIZES[0] ? FRAMES.told : FRAMES.other;
      console.log(`${size.width} x ${size.height}, ${close(zoom)}: ms of a core a frame`);
      console.log(HEAD);
      const rows = shapes.map(({ id, maps }) => {
        const result = subject(engine, pulled(maps), size, zoom, count);
        console.log(row(id, result));
        return result;
      });
      told ??= { ...size, rows };
      if (zoom > 1) continue;
      for (const [from, to] of MORPHS) {
        const ends = [from, to].map((id) => shapes.find((shape) => shape.id === id));
        if (ends.every(Boolean))
          console.log(row(`${from} - ${to}`, subject(engine, morphed(engine, ...ends), size, 1, count)));
      }
    }
  }
  return told;
}

/** The last line: of the median frames of all shapes, the one in the middle and the slowest. */
export function summary({ width, height, rows }) {
  const of = (kind) => {
    const all = rows.map((row) => median(row[kind].cpu));
    return `median ${ms(median(all)).trim()} ms, worst ${ms(Math.max(...all)).trim()} ms`;
  };
  return `frames: ${of("draft")} at ${width} x ${height} in motion; complete: ${of("complete")}`;
}

/** Two engines side by side: of each shape the median frame by either, and the median of all ratios. */
export function against(one, other, shapes) {
  const engines = [one, other];
  warm(engines, shapes[0].maps);
  const size = SIZES[0];
  const lines = { draft: [], complete: [] };
  console.log(`${size.width} x ${size.height}: ms of a core a frame, one engine and the other`);
  for (const { id, maps } of shapes) {
    const told = ["draft", "complete"].map((kind) => {
      const options = { ...size, draft: kind === "draft" };
      const times = measure(engines, pulled(maps), () => options, FRAMES.told[kind === "draft" ? 0 : 1]);
      const [a, b] = times.map(({ cpu }) => median(cpu));
      lines[kind].push({ a, b });
      return `${kind}${ms(a)}${ms(b)}  ${(a / b).toFixed(2)}`;
    });
    const pictures = engines.map((engine) => engine.rasterize({ maps }, size));
    const { missing, extra } = compare(pictures[0], pictures[1]);
    console.log(`  ${id.padEnd(20)}${told.join(" | ")} | pixels ${percent(missing)}${percent(extra)}`);
  }
  for (const [kind, all] of Object.entries(lines)) {
    const [a, b] = ["a", "b"].map((which) => all.map((line) => line[which]));
    const ratios = all.map((line) => line.a / line.b);
    console.log(
      `${kind}: median ${ms(median(a))} and ${ms(median(b))} ms, worst ${ms(Math.max(...a))} and ` +
        `${ms(Math.max(...b))} ms; ratios ${quantile(ratios, 0.1).toFixed(2)} to ${quantile(ratios, 0.9).toFixed(2)}, ` +
        `in the middle ${median(ratios).toFixed(2)}`,
    );
  }
}
