/** A small tree in points, and the same from another side. */

import { after3, scale3, shift3, turns3 } from "#geometry/affine3";
import type { SpaceView } from "#wasm/api";
import { SpaceDots } from "../space/space-dots";

/** A trunk, and three boughs that lean out around it. */
const TREE = [
  scale3([0.04, 0.04, 0.42]),
  ...[0.3, 2.4, 4.5].map((spin) =>
    after3(shift3([0, 0, 0.36]), after3(turns3([0.62, 0, spin]), scale3([0.58, 0.58, 0.6]))),
  ),
  after3(shift3([0, 0, 0.4]), scale3([0.5, 0.5, 0.5])),
];
const FRONT: SpaceView = { target: [0, 0, 0.42], distance: 3, turn: 0.3, tilt: 0.1, angle: 0.36 };
const ASIDE: SpaceView = { ...FRONT, turn: 2.1, tilt: 0.35 };

export const Tree = () => <SpaceDots maps={TREE} view={FRONT} />;
export const TreeTurned = () => <SpaceDots maps={TREE} view={ASIDE} />;
