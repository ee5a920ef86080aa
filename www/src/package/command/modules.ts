/** The modules of the package, as Node loads them, and what is asked of several of them. */
import type { MapRow3, SpaceLight, SpaceView } from "#wasm/api";

export type Draw = typeof import("../../../pkg/frond.js");
export type Proof = typeof import("../../../pkg/frond-proof.js");
export type Exact = typeof import("../../../pkg/frond-exact.js");
export type Exchange = typeof import("../../../pkg/frond-exchange.js");
export type Directed = typeof import("../../../pkg/frond-directed.js");
export type Solid = typeof import("../../../pkg/frond-space.js");
export type Curves = typeof import("../../../pkg/frond-curve.js");
export type Fitting = typeof import("../../../pkg/frond-fit.js");
export type Tables = typeof import("../../../pkg/frond-text.js");
export type Drawings = typeof import("../../../pkg/frond-svg.js");
export type Pixels = Uint8ClampedArray<ArrayBuffer>;

export interface Picture3 {
  objects: { maps: MapRow3[]; tint?: string }[];
  view: SpaceView;
  light: SpaceLight;
  look: { width: number; height: number; factor: number; palette: string[]; ground: string };
}
