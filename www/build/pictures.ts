/** Pictures that the program makes of its own shapes while the site is built. */
import { readFileSync } from "node:fs";
import { deflateSync } from "node:zlib";
import { NIGHT } from "../src/style/colours.ts";
import { channelsOf } from "../src/style/hex.ts";
import { palette } from "../src/style/palette.ts";
import { chunkBytes, PNG_SIGNATURE } from "../src/workers/image/png.ts";

export interface Shape {
  id: string;
  name: string;
  about: string;
  maps: number[][];
}

export interface Drawer {
  /** The gallery. */
  shapes(): Shape[];
  /** A moment of the way from one shape to another. */
  between(a: Shape, b: Shape, t: number): number[][];
  /** A shape on a dark ground, as a PNG; `free` is how much of the shorter side is free around it. */
  picture(maps: number[][], width: number, height: number, free: number): Uint8Array;
}

type Module = typeof import("../pkg/frond.js");

/** What draws. The module is there when the site is built, and need not be before. */
export async function drawer(): Promise<Drawer> {
  const here: string = new URL("../pkg/frond.js", import.meta.url).href;
  const module: Module = await import(/* @vite-ignore */ here);
  module.initSync({ module: readFileSync(new URL("../pkg/frond_bg.wasm", import.meta.url)) });
  return {
    shapes: () => module.presets() as unknown as Shape[],
    between: (a, b, t) => {
      const { from, to } = module.pair({ maps: a.maps } as never, { maps: b.maps } as never);
      return module.interpolate({ maps: from }, { maps: to }, { u: t, v: t }).maps;
    },
    picture: (maps, width, height, free) => picture(module, maps, width, height, free),
  };
}

function picture(frond: Module, maps: number[][], width: number, height: number, free: number): Uint8Array {
  const { min, max } = frond.bounds({ maps } as never);
  const room = 1 - 2 * free;
  const side = Math.min(width, height);
  const [across, up] = [width - side * (1 - room), height - side * (1 - room)];
  const scale = Math.min(across / (max[0] - min[0] || 1), up / (max[1] - min[1] || 1));
  const view = { x: (min[0] + max[0]) / 2, y: (min[1] + max[1]) / 2, scale };
  const pixels = frond.rasterize({ maps } as never, { width, height, view, palette: palette("dark") });
  const ground = channelsOf(NIGHT);
  // A row begins with the number of its filter: none.
  const rows = new Uint8Array(height * (3 * width + 1));
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const [from, to] = [4 * (y * width + x), y * (3 * width + 1) + 1 + 3 * x];
      const alpha = (pixels[from + 3] ?? 0) / 255;
      for (let i = 0; i < 3; i++)
        rows[to + i] = Math.round((pixels[from + i] ?? 0) * alpha + (ground[i] ?? 0) * (1 - alpha));
    }
  }
  const head = new Uint8Array(13);
  new DataView(head.buffer).setUint32(0, width);
  new DataView(head.buffer).setUint32(4, height);
  // Eight bits of red, green and blue.
  head.set([8, 2], 8);
  return Buffer.concat([
    Uint8Array.from(PNG_SIGNATURE),
    chunkBytes({ type: "IHDR", data: head }),
    chunkBytes({ type: "IDAT", data: deflateSync(rows) }),
    chunkBytes({ type: "IEND", data: new Uint8Array() }),
  ]);
}
