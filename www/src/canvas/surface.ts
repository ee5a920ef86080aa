import type { MapRow } from "../engine/api";
import type { RenderStyle } from "../engine/wasm";
import type { View } from "./geometry";

/** Straight alpha, row 0 on top. */
export interface Pixels {
  width: number;
  height: number;
  data: Uint8ClampedArray;
}

/** Something that fills a canvas with an attractor. Sizes are device pixels. */
export interface Surface {
  readonly canvas: HTMLCanvasElement;
  setMaps(maps: MapRow[]): void;
  setView(view: View, ratio: number): void;
  setStyle(style: RenderStyle): void;
  resize(width: number, height: number): void;
  draw(budget: number): { complete: boolean; points: number };
  pixels(): Promise<Pixels>;
  free(): void;
}
