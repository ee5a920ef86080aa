/** From files to outlines, inside a worker. What goes in and comes out is told in `trace-types`. */

import type { FitModule } from "#wasm/fit";
import { loadDrawings, loadTables } from "#wasm/text";
import { type Decoded, decode } from "../image/decode";
import { HEAD_BYTES, type Header, readHeader } from "../image/header";
import { inWords, MOST_MEGAPIXELS, shortName } from "../image/limits";
import { otherWords } from "../image/signature";
import { isWhole } from "../image/whole";
import type { Context } from "./context";
import type {
  CloseFileArgs,
  MaskArgs,
  Masked,
  Opened,
  OpenedOutlines,
  OpenedPicture,
  OpenedSeries,
  OpenFileArgs,
  OutlineArgs,
  TracedOutline,
  TraceWarning,
  TurnArgs,
} from "./trace-types";

type PictureTracer = InstanceType<FitModule["PictureTracer"]>;
type Plain = Context<never>;

/** The most pixels that are worked on, and the most bytes of a text and of a picture. */
const MOST_PIXELS = 1 << 22;
const MOST_TEXT = 64 << 20;
const MOST_BYTES = 128 << 20;
/** Pictures are large: of more than so many the one that was used longest ago goes. */
const MOST_HELD = 4;

const KEEP = "pictures";

interface Held {
  next: number;
  tracers: Map<number, PictureTracer>;
}

function held(keep: Map<string, unknown>): Held {
  const all = (keep.get(KEEP) as Held | undefined) ?? { next: 1, tracers: new Map() };
  keep.set(KEEP, all);
  return all;
}

function tracer(keep: Map<string, unknown>, id: number): PictureTracer {
  const { tracers } = held(keep);
  const found = tracers.get(id);
  if (!found) throw { code: "gone", message: "The picture is no longer at hand. Open the file again." };
  tracers.delete(id);
  tracers.set(id, found);
  return found;
}

/** Why a picture is not decoded; null where it may be. */
export function refusal(name: string, { kind, size }: Header, bytes: number): TraceProblem | null {
  if (bytes > MOST_BYTES) return tooLarge(name, `${Math.round(bytes / 2 ** 20)} megabytes`, "128");
  // An AVIF may not say; whatever else does not is not whole.
  if (!size) return kind === "avif" ? null : damaged(name);
  const megapixels = (size.width * size.height) / 1e6;
  return megapixels > MOST_MEGAPIXELS ? tooLarge(name, inWords(size), String(MOST_MEGAPIXELS)) : null;
}

interface TraceProblem {
  code: string;
  message: string;
}

function tooLarge(name: string, size: string, most: string): TraceProblem {
  const message = `“${name}” has ${size}, and at most ${most} can be opened. Make it smaller first, or cut out the leaf.`;
  return { code: "too-large", message };
}

function damaged(name: string): TraceProblem {
  const message = `“${name}” is damaged or ends too soon, so that it cannot be read. Save or copy it again, or take another.`;
  return { code: "damaged", message };
}

/** A file of a kind that is known and not read. */
export function unread(name: string, other: string): TraceProblem {
  return { code: "unknown-file", message: `“${name}” is ${otherWords(other)}` };
}

async function picture(file: Blob, name: string, header: Header): Promise<Decoded> {
  const refused = refusal(name, header, file.size);
  if (refused) throw refused;
  if (!isWhole(header.kind, new Uint8Array(await file.arrayBuffer()))) throw damaged(name);
  let decoded: Decoded | null;
  try {
    // What an AVIF says of itself is not binding.
    decoded = await decode(file, MOST_PIXELS, header.kind === "avif" ? undefined : header.size);
  } catch {
    throw damaged(name);
  }
  if (!decoded) throw tooLarge(name, `more than ${MOST_MEGAPIXELS} megapixels`, String(MOST_MEGAPIXELS));
  return decoded;
}

type Read = Omit<OpenedOutlines, "name"> | Omit<OpenedSeries, "name">;

/** Reads a text, which says itself whether it is a drawing. */
async function readText(bytes: Uint8Array, as: OpenFileArgs["as"]): Promise<Read> {
  try {
    return (await loadTables()).readTextFile(bytes, as);
  } catch (problem) {
    if ((problem as { code?: unknown }).code !== "drawing") throw problem;
    return (await loadDrawings()).readDrawing(bytes);
  }
}

/** Says which file it is of which something is amiss. */
function about(name: string, problem: unknown): unknown {
  if (!(problem instanceof Error) || problem instanceof WebAssembly.RuntimeError) return problem;
  const { code = "failed" } = problem as Error & { code?: string };
  return { code, message: `“${name}”: ${problem.message}` };
}

/** Keeps the pixels of a picture; returns its number. */
function hold(
  fit: FitModule,
  keep: Map<string, unknown>,
  width: number,
  height: number,
  pixels: Uint8ClampedArray<ArrayBuffer>,
): number {
  const all = held(keep);
  for (const [id, oldest] of all.tracers) {
    if (all.tracers.size < MOST_HELD) break;
    oldest.free();
    all.tracers.delete(id);
  }
  const id = all.next++;
  all.tracers.set(id, new fit.PictureTracer(width, height, new Uint8Array(pixels.buffer)));
  return id;
}

export const traceTasks = {
  /** Finds out what a file is, by what is in it, and opens it. */
  async openFile({ fit, keep, transfer }: Plain, { file, name: given, as }: OpenFileArgs): Promise<Opened> {
    const name = shortName(given, "File");
    const head = new Uint8Array(await file.slice(0, HEAD_BYTES).arrayBuffer());
    const header = readHeader(head);
    if (header.other !== undefined) throw unread(name, header.other);
    if (header.kind === "svg" || header.kind === "unknown") {
      if (file.size > MOST_TEXT) {
        throw tooLarge(name, `${Math.round(file.size / 2 ** 20)} megabytes of text`, "64");
      }
      const bytes = head.length === file.size ? head : new Uint8Array(await file.arrayBuffer());
      try {
        const read = await readText(bytes, as);
        for (const { points } of read.kind === "series" ? [read] : read.outlines) transfer(points.buffer);
        return { ...read, name };
      } catch (problem) {
        throw about(name, problem);
      }
    }
    const decoded = await picture(file, name, header);
    const { width, height, original, bitmap, pixels } = decoded;
    const id = hold(fit, keep, width, height, pixels);
    transfer(bitmap);
    const opened: OpenedPicture = {
      kind: "picture",
      id,
      name,
      width,
      height,
      original,
      bitmap,
      warnings: [],
    };
    if (width < original.width || height < original.height) opened.warnings.push(smaller(name, opened));
    return opened;
  },

  /** The same picture, turned: another one, beside it. */
  turnPicture({ fit, keep, transfer }: Plain, { picture: before, quarters }: TurnArgs): OpenedPicture {
    const upright = (size: { width: number; height: number }) =>
      quarters === 2 ? size : { width: size.height, height: size.width };
    const { width, height } = upright(before);
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext("2d", { willReadFrequently: true });
    if (!context) throw new Error("no canvas");
    // Pixels fall on pixels.
    if (quarters === 1) context.setTransform(0, 1, -1, 0, width, 0);
    else if (quarters === 2) context.setTransform(-1, 0, 0, -1, width, height);
    else context.setTransform(0, -1, 1, 0, 0, height);
    context.drawImage(before.bitmap, 0, 0);
    before.bitmap.close();
    const { data } = context.getImageData(0, 0, width, height);
    const id = hold(fit, keep, width, height, data);
    const bitmap = canvas.transferToImageBitmap();
    transfer(bitmap);
    return { ...before, id, width, height, original: upright(before.original), bitmap, warnings: [] };
  },

  /** Draws the mask of a picture. */
  mask({ keep, transfer }: Plain, { id, strokes: all, ...options }: MaskArgs): Masked {
    const strokes = all.filter(({ exact }) => exact);
    const hints = all.filter(({ exact }) => !exact);
    const masked = tracer(keep, id).mask({ ...options, strokes, hints });
    transfer(masked.mask.buffer);
    // Its warnings have a code that the page knows.
    return masked as Masked;
  },

  /** The line round a piece of the last mask. */
  outline({ keep, transfer }: Plain, { id, component }: OutlineArgs): TracedOutline {
    const traced = tracer(keep, id).outline(component);
    transfer(traced.points.buffer);
    return traced as TracedOutline;
  },

  /** Lets go of a picture. */
  closeFile({ keep }: Plain, { id }: CloseFileArgs): null {
    const { tracers } = held(keep);
    tracers.get(id)?.free();
    tracers.delete(id);
    return null;
  },
};

function smaller(name: string, { original, width, height }: OpenedPicture): TraceWarning {
  const side = (pixels: number) => pixels.toLocaleString("en-GB");
  const message = `“${name}” has ${inWords(original)}: it is worked on at ${side(width)} × ${side(height)}.`;
  return { code: "smaller", message };
}
