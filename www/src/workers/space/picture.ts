import type { SpaceLight, SpaceShown, SpaceView } from "#wasm/api";
import { type SpaceCarveHandle, type SpaceLook, type SpacePictureHandle, solid } from "#wasm/space";
import type { Context } from "../lanes/task";

/** As much of an object as a picture shows. */
export type Shown = SpaceShown;

/** One complete picture. `width` x `height` pixels, of which `factor` x `factor` are carved for each. */
export interface PictureRequest extends SpaceLook {
  objects: Shown[];
  view: SpaceView;
  light: SpaceLight;
}

export interface Painted {
  width: number;
  height: number;
  /** RGBA, straight alpha, row 0 on top. */
  data: Uint8ClampedArray<ArrayBuffer>;
}

/** Rows of what is carved, from the first of these on, before the second. */
export type Rows = readonly [from: number, to: number];

/** Some rows of a picture. */
export interface BandRequest extends PictureRequest {
  rows: Rows;
  /** How far hollows are looked for: 1 in a picture that has as many pixels as it is to have in the end. */
  reach: number;
  /** Whether to tell which pieces are seen as well. */
  codes: boolean;
}

export interface Band {
  /** RGBA, straight alpha, row 0 on top. */
  data: Uint8ClampedArray<ArrayBuffer>;
  codes: Uint32Array<ArrayBuffer> | null;
}

/** What a renderer makes a complete picture of. */
export interface Relief {
  width: number;
  height: number;
  depth: Float32Array<ArrayBuffer>;
  codes: Uint32Array<ArrayBuffer>;
  /** There is nothing in it. */
  empty: boolean;
}

export interface ReliefRequest {
  objects: Shown[];
  view: SpaceView;
  width: number;
  height: number;
  rows?: Rows;
}

/** Some rows of what the lamp of a picture sees: `width` x `height` are those of the picture. */
export interface LampRequest {
  objects: Shown[];
  view: SpaceView;
  light: SpaceLight;
  width: number;
  height: number;
  rows: Rows;
}

/** Rows of a picture that was carved before, to be lit. */
export interface LitRequest extends PictureRequest {
  rows: Rows;
  reach: number;
  /** The first row of the depths and the codes. */
  top: number;
  depth: Float32Array<ArrayBuffer>;
  codes: Uint32Array<ArrayBuffer>;
  /** All that the lamp sees; nothing where no shadows are cast. */
  lamp: Float32Array<ArrayBuffer>;
}

/** Codes have the number of the object above so many bits, as the carving writes them. */
const OBJECT_BITS = 18;

/** The object at a place of a relief, from 0 to 1 across and down; null where there is none. */
export function objectAt(
  { width, height, codes }: Pick<Relief, "width" | "height" | "codes">,
  x: number,
  y: number,
): number | null {
  if (!(x >= 0 && x < 1 && y >= 0 && y < 1)) return null;
  const code = codes[Math.floor(y * height) * width + Math.floor(x * width)] ?? 0;
  return code === 0 ? null : (code - 1) >>> OBJECT_BITS;
}

/** So many pieces at first; then as many as fit between two breaths. */
const FIRST_PIECES = 20_000;
const LEAST_PIECES = 2_000;
const MOST_PIECES = 20_000_000;
/** Milliseconds from breath to breath. */
const BREATH = 30;
const KEPT = "picture";

export const pictureTasks = {
  /** The complete picture, in its colours. */
  async picture(context: Context, request: PictureRequest): Promise<Painted> {
    const { objects, view, light, width, height, palette, ground, factor } = request;
    const carve = pictured(context, objects).carve(view, width * factor, height * factor);
    try {
      await carved(context, carve);
      // Declared as what may be shared memory; it never is. The same below.
      const look = { width, height, factor, palette, ground };
      const data = carve.paint(light, look) as Uint8ClampedArray<ArrayBuffer>;
      context.transfer(data.buffer);
      return { width, height, data };
    } finally {
      carve.free();
    }
  },

  /** Some rows of it. */
  async band(context: Context, request: BandRequest): Promise<Band> {
    const { objects, view, light, width, height, palette, ground, factor, rows, reach } = request;
    const picture = pictured(context, objects);
    const carve = picture.carveRows(view, width * factor, height * factor, ...rows, reach);
    try {
      await carved(context, carve);
      const look = { width, height, factor, palette, ground };
      const data = carve.paint(light, look) as Uint8ClampedArray<ArrayBuffer>;
      const codes = request.codes ? (carve.codes() as Uint32Array<ArrayBuffer>) : null;
      context.transfer(data.buffer, ...(codes ? [codes.buffer] : []));
      return { data, codes };
    } finally {
      carve.free();
    }
  },

  /** The complete picture before it is coloured, or some rows of it: `width` x `height` are what is carved. */
  async relief(
    context: Context,
    { objects, view, width, height, rows = [0, height] }: ReliefRequest,
  ): Promise<Relief> {
    const carve = pictured(context, objects).carveRows(view, width, height, ...rows, 0);
    try {
      await carved(context, carve);
      const depth = carve.depth() as Float32Array<ArrayBuffer>;
      const codes = carve.codes() as Uint32Array<ArrayBuffer>;
      context.transfer(depth.buffer, codes.buffer);
      return { width, height: rows[1] - rows[0], depth, codes, empty: codes.every((code) => code === 0) };
    } finally {
      carve.free();
    }
  },

  /** Some rows of what the lamp sees. */
  async lamp(context: Context, request: LampRequest): Promise<Float32Array<ArrayBuffer>> {
    const { objects, view, light, width, height, rows } = request;
    const carve = pictured(context, objects).carveLamp(view, light, width, height, ...rows);
    try {
      await carved(context, carve);
      const depth = carve.depth() as Float32Array<ArrayBuffer>;
      context.transfer(depth.buffer);
      return depth;
    } finally {
      carve.free();
    }
  },

  /** Lights rows of what was carved before. */
  async lit(context: Context, request: LitRequest): Promise<Uint8ClampedArray<ArrayBuffer>> {
    const { objects, view, light, width, height, palette, ground, factor } = request;
    const { rows, reach, top, depth, codes, lamp } = request;
    const look = { width, height, factor, palette, ground };
    const picture = pictured(context, objects);
    const data = picture.lightRows(view, light, look, { top, rows }, depth, codes, lamp, reach);
    context.transfer(data.buffer);
    return data as Uint8ClampedArray<ArrayBuffer>;
  },
};

interface Kept {
  key: string;
  picture: SpacePictureHandle;
}

/** The objects made ready, once for as long as they stay the same: often it is only the eye that has moved. */
function pictured({ keep }: Context, objects: Shown[]): SpacePictureHandle {
  const key = JSON.stringify(objects);
  const kept = keep.get(KEPT) as Kept | undefined;
  if (kept?.key === key) return kept.picture;
  keep.delete(KEPT);
  try {
    const picture = kept ? kept.picture.next(objects) : new solid.SpacePicture(objects);
    keep.set(KEPT, { key, picture } satisfies Kept);
    return picture;
  } finally {
    kept?.picture.free();
  }
}

/** In slices, so that a picture that nobody wants any more is left unfinished. */
async function carved({ breathe }: Context, carve: SpaceCarveHandle): Promise<void> {
  let breath = performance.now();
  for (let budget = FIRST_PIECES; ; ) {
    const before = performance.now();
    if (carve.run(Math.round(budget))) return;
    const now = performance.now();
    const took = Math.max(0.5, now - before);
    budget = Math.min(MOST_PIECES, Math.max(LEAST_PIECES, budget * Math.min(4, BREATH / took)));
    // A breath takes as long as a small picture.
    if (now - breath < BREATH) continue;
    await breathe();
    breath = performance.now();
  }
}
