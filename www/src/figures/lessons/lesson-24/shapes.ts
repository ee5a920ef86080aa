/** The shapes of space of this lesson, all of whose maps only shrink, and their shadows. */
import type { Box } from "#document/framing";
import type { MapRow, MapRow3, Point3, SpaceView } from "#wasm/api";
import { axesOf } from "../../darwish/space/eye";
import { number, parts } from "../../kit/state/fields";

/** Towards each of these corners, by one factor: r x + (1 - r) c. */
function scalings(r: number, corners: readonly Point3[]): MapRow3[] {
  return corners.map(([x, y, z]): MapRow3 => {
    const k = 1 - r;
    return [r, 0, 0, 0, r, 0, 0, 0, r, k * x, k * y, k * z];
  });
}

const SIDES = [-1, 0, 1] as const;
/** The small cubes of 27 that stay: all but the middle one and those in the middles of the faces. */
const KEPT = SIDES.flatMap((x) => SIDES.flatMap((y) => SIDES.map((z): Point3 => [x, y, z]))).filter(
  (place) => place.filter((side) => side === 0).length <= 1,
);

/** Menger's sponge in the cube from -1 to 1. */
export const SPONGE: MapRow3[] = scalings(1 / 3, KEPT);

/** The tetrahedron that lies on an edge: two opposite edges are level, and cross at right angles seen from above. */
export const LYING: MapRow3[] = scalings(1 / 2, [
  [1, 1, 1],
  [-1, -1, 1],
  [1, -1, -1],
  [-1, 1, -1],
]);

const HIGH = Math.sqrt(3);
/** The height of the foot under the middle, and how far its corners are from the axis. */
const [LOW, OUT] = [-HIGH / 3, (HIGH * Math.sqrt(8)) / 3];
const FOOT: readonly Point3[] = [90, 210, 330].map((degrees) => {
  const angle = (degrees * Math.PI) / 180;
  return [OUT * Math.cos(angle), OUT * Math.sin(angle), LOW];
});
const STANDING_CORNERS: readonly Point3[] = [[0, 0, HIGH], ...FOOT];

/** The same tetrahedron, standing on a face. */
export const STANDING: MapRow3[] = scalings(1 / 2, STANDING_CORNERS);

/** From where it is looked at, in degrees. */
export interface Eye {
  turn: number;
  tilt: number;
}

/** As it stands in the address of the lesson. */
export const EYE = parts<Eye>({ turn: number(-720, 720, 1), tilt: number(-90, 90, 1) });

/** All are as far from the middle at most. */
const RADIUS = Math.sqrt(3);
/** From so far away sizes hardly depend on depth: the eye is where the lamp is. */
const DISTANCE = 14 * RADIUS;
const radians = (degrees: number) => (degrees * Math.PI) / 180;

export function viewOf({ turn, tilt }: Eye): SpaceView {
  const angle = 2 * Math.asin((1.12 * RADIUS) / DISTANCE);
  return { target: [0, 0, 0], distance: DISTANCE, turn: radians(turn), tilt: radians(tilt), angle };
}

export const eyeOf = ({ turn, tilt }: SpaceView): Eye => ({
  turn: (turn * 180) / Math.PI,
  tilt: (tilt * 180) / Math.PI,
});

export const SHADOW_BOX: Box = { x0: -RADIUS, x1: RADIUS, y0: -RADIUS, y1: RADIUS };

/** What makes the shadow: the projection of r x + t is r times that of x, and that of t. */
export function shadowMaps(maps: readonly MapRow3[], eye: Eye): MapRow[] {
  const { right, up } = axesOf(viewOf(eye));
  return maps.map((map): MapRow => {
    const t: Point3 = [map[9], map[10], map[11]];
    return [map[0], 0, 0, map[0], dot(right, t), dot(up, t)];
  });
}

const dot = (p: Point3, q: Point3) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];

/** Along the diagonals of its cube the shadow of the sponge is a hexagon. */
const DIAGONALS: readonly Point3[] = [
  [1, 1, 1],
  [1, 1, -1],
  [1, -1, 1],
  [-1, 1, 1],
];
/** Through the middles of opposite edges the shadow of the standing tetrahedron is a square. */
const THROUGH_EDGES: readonly Point3[] = FOOT.map(([x, y, z]): Point3 => [x, y, z + HIGH]);

/** How far off the nearest of some directions the line of sight is, in degrees; it has no front and no back. */
function off(eye: Eye, directions: readonly Point3[]): number {
  const { ahead } = axesOf(viewOf(eye));
  const nearest = Math.max(
    ...directions.map((way) => Math.abs(dot(ahead, way)) / Math.hypot(way[0], way[1], way[2])),
  );
  return (Math.acos(Math.min(1, nearest)) * 180) / Math.PI;
}

export const offDiagonal = (eye: Eye) => off(eye, DIAGONALS);
export const offEdges = (eye: Eye) => off(eye, THROUGH_EDGES);
/** So near counts as found. */
export const NEAR_DEGREES = 1;
