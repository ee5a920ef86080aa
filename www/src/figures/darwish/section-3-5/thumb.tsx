import { about3, scale3 } from "#geometry/maps/affine3";
import type { SpaceView } from "#wasm/api";
import { SpaceDots } from "../space/space-dots";

/** A tetrahedron, nearly flat. */
const MAPS = (
  [
    [1, 1, 0.03],
    [1, -1, -0.03],
    [-1, 1, -0.03],
    [-1, -1, 0.03],
  ] as const
).map((corner) => about3(scale3([0.5, 0.5, 0.5]), [...corner]));
const ASIDE: SpaceView = { target: [0, 0, 0], distance: 7, turn: 0.5, tilt: 0.4, angle: 0.42 };

export const Thumb = () => <SpaceDots maps={MAPS} view={ASIDE} />;
