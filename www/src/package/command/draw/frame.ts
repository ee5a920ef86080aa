/** A picture, drawn and packed in a worker: what comes back is small, and the main thread has little to do. */
import { zlibSync } from "fflate";
import type { DirectedIfs, Ifs } from "#wasm/api";
import { gifIndices } from "#workers/film/format/gif";
import { type Colour, matcher } from "#workers/film/format/gif-colours";
import { pngOf, RowFilter } from "#workers/film/format/png-rows";
import { layOn } from "#workers/film/opaque";
import type { Context } from "#workers/lanes/task";
import { type Sources, solidPixels } from "../../tasks";
import type { Directed, Draw, Picture3, Pixels } from "../modules";

/** What is to be seen. */
export type Drawing =
  | { kind: "plane"; ifs: Ifs; options: Parameters<Draw["rasterize"]>[1] }
  | { kind: "states"; ifs: DirectedIfs; options: Parameters<Directed["rasterizeDirected"]>[1] }
  | { kind: "space"; picture: Picture3 };

export interface Frame {
  drawing: Drawing;
  width: number;
  height: number;
  /** "#rrggbb" is laid behind it; null leaves clear what is clear. */
  ground: string | null;
}

export type PngFrame = Frame & { link: string | null };

export interface IndexedFrame extends Frame {
  colours: readonly Colour[];
  /** Tells sets of colours apart, so that a worker prepares each only once. */
  key: number;
}

export type FrameSources = Sources & { directed(): Promise<unknown> };
type Hand = Context<number> & { sources: FrameSources };

export const frameTasks = {
  async pixels(hand: Hand, frame: Frame): Promise<Pixels> {
    const pixels = await drawn(hand, frame);
    hand.transfer(pixels.buffer);
    return pixels;
  },

  /** A PNG file. Its bytes are the same on every machine, which those of the platform's own packers are not. */
  async png(hand: Hand, frame: PngFrame): Promise<Uint8Array<ArrayBuffer>> {
    const { width, height, ground, link } = frame;
    const settings = { width, height, opaque: ground !== null, link, ground };
    const rows = new RowFilter(settings).filtered(await drawn(hand, frame));
    const file = pngOf(settings, zlibSync(rows));
    hand.transfer(file.buffer);
    return file;
  },

  /** The numbers of its colours, as a GIF holds them. */
  async indices(hand: Hand, frame: IndexedFrame): Promise<Uint8Array<ArrayBuffer>> {
    const { colours, key, ground } = frame;
    const known = hand.keep.get("colours") as
      | { key: number; nearest: ReturnType<typeof matcher> }
      | undefined;
    const nearest = known?.key === key ? known.nearest : matcher(colours);
    hand.keep.set("colours", { key, nearest });
    const index = gifIndices(await drawn(hand, frame), nearest, ground);
    hand.transfer(index.buffer);
    return index;
  },
};

async function drawn(hand: Hand, { drawing, ground }: Frame): Promise<Pixels> {
  const pixels = await picture(hand, drawing);
  if (ground !== null) layOn(pixels, ground);
  return pixels;
}

async function picture(hand: Hand, drawing: Drawing): Promise<Pixels> {
  switch (drawing.kind) {
    case "plane": {
      const { rasterize } = (await hand.sources.draw()) as Draw;
      return rasterize(drawing.ifs, drawing.options) as Pixels;
    }
    case "states": {
      const { rasterizeDirected } = (await hand.sources.directed()) as Directed;
      return rasterizeDirected(drawing.ifs, drawing.options) as Pixels;
    }
    case "space":
      return (await solidPixels(hand, drawing.picture)) as Pixels;
  }
}
