/** Where a picture of space is seen from. */

import { apply3, determinant3 } from "#geometry/maps/affine3";
import type { MapRow3, Point3, SpaceView } from "#wasm/api";
import { type Field, list, number } from "../../kit/state/fields";

const STEEPEST = Math.PI / 2;
/** Where it looks, from how far, how turned and tilted, and how wide: no scene of a page is larger. */
const NUMBERS = list(number(-1e6, 1e6, 6), 7, 7);

/** As it stands in an address. */
export const VIEW: Field<SpaceView> = {
  write: ({ target, distance, turn, tilt, angle, holds }) =>
    [NUMBERS.write([...target, distance, turn, tilt, angle]), ...(holds ? [holds] : [])].join(";"),
  read(text) {
    const [numbers = "", holds, ...more] = text.split(";", 3);
    const read = NUMBERS.read(numbers);
    if (!read || more.length > 0 || (holds !== undefined && holds !== "eye")) return null;
    const [x = 0, y = 0, z = 0, distance = 0, turn = 0, tilt = 0, angle = 0] = read;
    const sees = distance > 0 && angle > 0 && angle < Math.PI && Math.abs(tilt) <= STEEPEST + 1e-4;
    const view: SpaceView = { target: [x, y, z], distance, turn, tilt, angle };
    return sees ? { ...view, ...(holds ? { holds } : {}) } : null;
  },
};

interface Axes {
  eye: Point3;
  right: Point3;
  up: Point3;
  ahead: Point3;
}

export function axesOf({ target, distance, turn, tilt }: SpaceView): Axes {
  const [s, c] = [Math.sin(turn), Math.cos(turn)];
  const [rise, flat] = [Math.sin(tilt), Math.cos(tilt)];
  const ahead: Point3 = [-s * flat, c * flat, -rise];
  return {
    right: [c, s, 0],
    up: [-s * rise, c * rise, flat],
    ahead,
    eye: target.map((x, k) => x - distance * (ahead[k] ?? 0)) as Point3,
  };
}

/** Turned by radians: about the target, or about the eye where that is held. */
export function orbited(view: SpaceView, turn: number, tilt: number): SpaceView {
  const whole = 2 * Math.PI;
  const around = view.turn + turn;
  const next = {
    ...view,
    turn: around - whole * Math.round(around / whole),
    tilt: Math.min(STEEPEST, Math.max(-STEEPEST, view.tilt + tilt)),
  };
  if (view.holds !== "eye") return next;
  const { eye } = axesOf(view);
  const { ahead } = axesOf(next);
  return { ...next, target: eye.map((x, k) => x + view.distance * (ahead[k] ?? 0)) as Point3 };
}

/** From the origin towards a point. */
export function fromOrigin([x, y, z]: Point3, angle: number): SpaceView {
  const distance = Math.hypot(x, y, z) || 1;
  const tilt = -Math.asin(z / distance);
  return { target: [x, y, z], distance, turn: Math.atan2(-x, y), tilt, angle, holds: "eye" };
}

/**
 * Where a point is in a picture: from -1 to 1 upwards, as far to the sides as the picture is wide, and how deep before
 * the eye.
 */
export function seen(view: SpaceView): (point: Point3) => readonly [x: number, y: number, depth: number] {
  const { eye, right, up, ahead } = axesOf(view);
  const slope = Math.tan(view.angle / 2);
  const dot = (p: Point3, q: Point3) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
  return (point) => {
    const from = point.map((x, k) => x - (eye[k] ?? 0)) as Point3;
    const depth = dot(from, ahead);
    return [dot(from, right) / (depth * slope), dot(from, up) / (depth * slope), depth];
  };
}

/** A few points by the chaos game, with the map that each came by: enough for a small picture. */
export function dotsOf(maps: readonly MapRow3[], count: number): { point: Point3; map: number }[] {
  const dots: { point: Point3; map: number }[] = [];
  const upTo = chances(maps);
  let point: Point3 = [0, 0, 0];
  let seed = 7;
  for (let i = -200; i < count && maps.length > 0; i++) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    const map = upTo.findIndex((chance) => seed / 2 ** 32 < chance);
    point = apply3(maps[map] as MapRow3, point);
    if (i >= 0) dots.push({ point, map });
  }
  return dots;
}

/** Large pieces get more points, and flat ones a few. Added up, so that the last is above everything. */
function chances(maps: readonly MapRow3[]): number[] {
  const volumes = maps.map((map) => Math.abs(determinant3(map)));
  const least = Math.max(...volumes) / 50 || 1;
  const weights = volumes.map((volume) => Math.max(volume, least));
  const all = weights.reduce((sum, weight) => sum + weight, 0);
  let sum = 0;
  return weights.map((weight, i) => {
    sum += weight;
    return i === weights.length - 1 ? 2 : sum / all;
  });
}
