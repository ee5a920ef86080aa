/** The outline that a file gives: of a drawing or a table as it is there, of a picture by tracing it. */
import type { OpenedOutlines, OpenedSeries } from "#workers/fit/trace-types";
import { number, type Options, Refusal, whole } from "../options";
import { nameOf, plainName } from "../subject";
import type { System } from "../system";
import { type Picture, pictureIn } from "./picture";

export interface Outline {
  name: string;
  /** x0, y0, x1, y1, .. with y up, counter-clockwise. */
  points: Float64Array;
}

/** --piece counts from 1. */
const MOST_PIECES = 100_000;

export async function outlineOf(word: string, options: Options, system: System): Promise<Outline> {
  const named = nameOf(word);
  const bytes = await system.read(word);
  const picture = await pictureIn(bytes, named);
  if (picture) return { name: plainName(word), points: await traced(picture, options, system) };
  const ofPictures = ["threshold", "no-stalk"].find((name) => options[name] !== undefined);
  if (ofPictures) throw new Refusal(`${named} is no picture, and has no --${ofPictures}.`);
  const { outlines, warnings } = await read(bytes, named, system);
  warn(warnings, system);
  const piece = pieceOf(options);
  const found = outlines[piece];
  if (!found) throw new Refusal(`There is no outline ${piece + 1} in ${named}: it has ${outlines.length}.`);
  if (outlines.length > 1 && options["piece"] === undefined)
    system.tell(
      `The largest of ${outlines.length} outlines, ${found.name}: others are chosen by --piece 2 ..`,
    );
  return { name: plainName(word), points: found.points };
}

const pieceOf = (options: Options) => whole(options, "piece", 1, MOST_PIECES, 1) - 1;

async function traced({ width, height, pixels, original }: Picture, options: Options, system: System) {
  const threshold = number(options, "threshold", -1, 1, 0);
  const component = pieceOf(options);
  const { traceOutline } = await system.fit();
  const stalk = options["no-stalk"] !== true;
  const found = traceOutline(pixels, width, height, { threshold, stalk, component });
  if (width !== original.width)
    system.tell(`${original.width} x ${original.height} pixels: traced at ${width} x ${height}.`);
  warn(found.warnings, system);
  return found.points;
}

async function read(bytes: Uint8Array, named: string, system: System): Promise<Omit<OpenedOutlines, "name">> {
  try {
    return await readText(bytes, system);
  } catch (problem) {
    if (!(problem instanceof Error) || problem instanceof WebAssembly.RuntimeError) throw problem;
    throw new Refusal(`${named}: ${problem.message}`);
  }
}

/** A text says itself whether it is a drawing. */
async function readText(bytes: Uint8Array, system: System): Promise<Omit<OpenedOutlines, "name">> {
  const tables = await system.tables();
  try {
    const first: OpenedOutlines | OpenedSeries = tables.readTextFile(bytes);
    return first.kind === "outlines" ? first : tables.readTextFile(bytes, "outlines");
  } catch (problem) {
    if ((problem as { code?: unknown }).code !== "drawing") throw problem;
    return (await system.drawings()).readDrawing(bytes);
  }
}

/** Nobody has a brush here: what the studio says of strokes is said in other words. */
const WORDS: Readonly<Partial<Record<string, string>>> = {
  holes: "It has holes, which are filled: an outline is one line around it.",
  several: "It is in several pieces, and the largest is taken: --piece 2 takes the next.",
};

function warn(warnings: readonly { code: string; message: string }[], system: System): void {
  for (const { code, message } of warnings) system.tell(WORDS[code] ?? message);
}
