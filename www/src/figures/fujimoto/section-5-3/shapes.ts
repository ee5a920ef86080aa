import type { MapRow3, SpaceView } from "#wasm/api";

export const SHAPES = [
  { value: "sponge", label: "Menger sponge" },
  { value: "tetrahedron", label: "Tetrahedron" },
] as const;
export type ShapeName = (typeof SHAPES)[number]["value"];

export const IDENTITY: MapRow3 = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];

/** From a little above, with room for what is pulled out. */
export const HOME: SpaceView = {
  target: [0.25, 0.15, 0.3],
  distance: 3.8,
  turn: 0.5,
  tilt: 0.42,
  angle: 0.7,
};
