/** Small pictures of the shapes of Figures i to vi, in points, and where they are seen from. */

import { about3, after3, scale3, shift3 } from "#geometry/maps/affine3";
import type { MapRow3, SpaceView } from "#wasm/api";
import { PYRAMID_AWAY, pyramidMiddle, TRIANGLE_MIDDLE } from "./shapes";

export const FRONT: SpaceView = { target: TRIANGLE_MIDDLE, distance: 3, turn: 0.35, tilt: 1.2, angle: 0.36 };
/** Along x, as the eye of the paper looks, but from nearby. */
export const ALONG_X: SpaceView = {
  target: [0, 0, 0],
  distance: 3,
  turn: -Math.PI / 2,
  tilt: 0,
  angle: 0.36,
};
export const FROM_FAR: SpaceView = {
  target: pyramidMiddle(PYRAMID_AWAY),
  distance: PYRAMID_AWAY,
  turn: -Math.PI / 2,
  tilt: 0,
  angle: 0.045,
};

/** Halves keep their matrices when they are turned: what is moved is where their corners are. */
export function turnedHalves(maps: readonly MapRow3[], by: MapRow3): MapRow3[] {
  return maps.map((map) => {
    const corner = [2 * map[9], 2 * map[10], 2 * map[11]] as const;
    const [x, y, z] = after3(by, shift3([...corner])).slice(9);
    return about3(scale3([0.5, 0.5, 0.5]), [x ?? 0, y ?? 0, z ?? 0]);
  });
}
