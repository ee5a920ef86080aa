/** A small tree of the natural scene. */

import { after3, scale3, shift3, turns3 } from "#geometry/maps/affine3";
import type { SpaceView } from "#wasm/api";

/** A trunk, and three boughs that lean out around it. */
export const TREE = [
  scale3([0.04, 0.04, 0.42]),
  ...[0.3, 2.4, 4.5].map((spin) =>
    after3(shift3([0, 0, 0.36]), after3(turns3([0.62, 0, spin]), scale3([0.58, 0.58, 0.6]))),
  ),
  after3(shift3([0, 0, 0.4]), scale3([0.5, 0.5, 0.5])),
];
export const TREE_VIEW: SpaceView = { target: [0, 0, 0.42], distance: 3, turn: 0.3, tilt: 0.1, angle: 0.36 };
