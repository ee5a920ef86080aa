/** Small pictures of the figures on space, in points. */

import { about3, after3, scale3, shift3, turns3 } from "#geometry/affine3";
import type { MapRow3, SpaceView } from "#wasm/api";
import { pyramid, triangle } from "./space/shapes";
import { SpaceDots } from "./space/space-dots";

const FRONT: SpaceView = { target: [0, 0, 0], distance: 3, turn: 0.35, tilt: 0.2, angle: 0.46 };
const FAR: SpaceView = { target: [15, 0, 0], distance: 15, turn: -Math.PI / 2, tilt: 0, angle: 0.075 };

const HALVES = triangle("halves");

/** Halves keep their matrices when they are turned: what is moved is where their corners are. */
function turnedHalves(maps: readonly MapRow3[], by: MapRow3): MapRow3[] {
  return maps.map((map) => {
    const corner = [2 * map[9], 2 * map[10], 2 * map[11]] as const;
    const [x, y, z] = after3(by, shift3([...corner])).slice(9);
    return about3(scale3([0.5, 0.5, 0.5]), [x ?? 0, y ?? 0, z ?? 0]);
  });
}

const TURNED = turnedHalves(HALVES, turns3([0.44, -0.61, 0.7]));
const AGAIN = turnedHalves(HALVES, turns3([-0.5, 0.4, -0.9]));
const ONCE_MORE = turnedHalves(HALVES, turns3([1, 0.9, 0.5]));
const PYRAMID = pyramid([15, 0, 0]);
const PYRAMID_TURNED = turnedHalves(PYRAMID, about3(turns3([0, 0.35, 0.7]), [15, 0, 0]));
/** A tetrahedron, nearly flat. */
const FLAT = (
  [
    [1, 1, 0.03],
    [1, -1, -0.03],
    [-1, 1, -0.03],
    [-1, -1, 0.03],
  ] as const
).map((corner) => about3(scale3([0.5, 0.5, 0.5]), [...corner]));
const ASIDE: SpaceView = { target: [0, 0, 0], distance: 7, turn: 0.5, tilt: 0.4, angle: 0.42 };

export const Upright = () => <SpaceDots maps={HALVES} view={FRONT} />;
export const Turned = () => <SpaceDots maps={TURNED} view={FRONT} />;
export const Again = () => <SpaceDots maps={AGAIN} view={FRONT} />;
export const OnceMore = () => <SpaceDots maps={ONCE_MORE} view={FRONT} />;
export const Pyramid = () => <SpaceDots maps={PYRAMID} view={FAR} />;
export const PyramidTurned = () => <SpaceDots maps={PYRAMID_TURNED} view={FAR} />;
export const Flat = () => <SpaceDots maps={FLAT} view={ASIDE} />;
