import type { Photograph } from "#document/deform/photograph";
import type { View } from "#geometry/coordinates";
import type { Bend, MapRow } from "#wasm/api";
import type { RenderStyle } from "#wasm/core";

/** Straight alpha, row 0 on top. */
export interface Pixels {
  width: number;
  height: number;
  data: Uint8ClampedArray;
}

export interface Drawn {
  /** Every pixel that holds a piece of the attractor is lit. */
  complete: boolean;
  /** Drawing on would change nothing. */
  settled: boolean;
  points: number;
  /** What is shown lacks nothing that one would see, complete or not. */
  whole?: boolean;
}

/** What a picture is to show. Sizes are device pixels. */
export interface Wanted {
  maps: MapRow[];
  /** How often the chaos game takes each map, where that is said. */
  weights: number[] | undefined;
  bend: Bend | null;
  picture: Photograph | null;
  view: View;
  style: RenderStyle;
  width: number;
  height: number;
  ratio: number;
}

/** Something that fills a canvas with an attractor. Sizes are device pixels. */
export interface Surface {
  readonly canvas: HTMLCanvasElement;
  /** What has to be fetched before it can be given this; null where all is there. */
  lacks?(wanted: Wanted): Promise<unknown> | null;
  setMaps(maps: MapRow[], weights: number[] | undefined): void;
  /** A picture in place of the attractor, or null: the maps are then those of the rectangle that it lies on. */
  setPicture(picture: Photograph | null): void;
  /** Throws where it cannot be had; the last one stays. */
  setBend(bend: Bend | null): void;
  setView(view: View, ratio: number): void;
  setStyle(style: RenderStyle): void;
  resize(width: number, height: number): void;
  draw(budget: number): Drawn;
  pixels(): Promise<Pixels>;
  free(): void;
}
