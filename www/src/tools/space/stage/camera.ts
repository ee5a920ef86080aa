/** Looking around in space: what becomes of a view when somebody turns, shifts or nears it. Pure. */
import type { Point3, SpaceView } from "#wasm/api";

/** A ball around what is to be seen. */
export interface Ball {
  centre: Point3;
  radius: number;
}

/** What goes to the right in the picture, what up, and where the eye looks: unit vectors. */
export interface Axes {
  right: Point3;
  up: Point3;
  ahead: Point3;
}

export const LEAST_ANGLE = (1 * Math.PI) / 180;
export const MOST_ANGLE = (170 * Math.PI) / 180;
const USUAL_ANGLE = (40 * Math.PI) / 180;
/** As near and as far as hands and wheels go, in radii of what there is. */
const NEAREST = 1e-5;
const FARTHEST = 1e4;
/** Room around what is to be seen. */
const MARGIN = 1.08;

const add = (p: Point3, q: Point3, by = 1): Point3 => [p[0] + by * q[0], p[1] + by * q[1], p[2] + by * q[2]];
const minus = (p: Point3, q: Point3): Point3 => add(p, q, -1);
const dot = (p: Point3, q: Point3): number => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];

export function axesOf({ turn, tilt }: SpaceView): Axes {
  const [s, c] = [Math.sin(turn), Math.cos(turn)];
  const [rise, flat] = [Math.sin(tilt), Math.cos(tilt)];
  return {
    right: [c, s, 0],
    // Over the top, up is where the turn points: the picture does not flip.
    up: [-s * rise, c * rise, flat],
    ahead: [-s * flat, c * flat, -rise],
  };
}

export function eyeOf(view: SpaceView): Point3 {
  return add(view.target, axesOf(view).ahead, -view.distance);
}

/** The same eye, with its target where it looks now. */
function aimed(view: SpaceView, eye: Point3): SpaceView {
  return { ...view, target: add(eye, axesOf(view).ahead, view.distance) };
}

/** Angles without the whole turns in them. */
export function wrapped(angle: number): number {
  const turn = 2 * Math.PI;
  const rest = angle - turn * Math.round(angle / turn);
  return rest <= -Math.PI ? rest + turn : rest;
}

/** Turned by radians, about what the view holds. */
export function turned(view: SpaceView, turn: number, tilt: number): SpaceView {
  const next = { ...view, turn: wrapped(view.turn + turn), tilt: wrapped(view.tilt + tilt) };
  return view.holds === "eye" ? aimed(next, eyeOf(view)) : next;
}

/** Units of space for a pixel, at a distance before the eye. */
function unitsAt(view: SpaceView, distance: number, height: number): number {
  return (2 * distance * Math.tan(view.angle / 2)) / Math.max(1, height);
}

/** Turned so that what is under the hand goes with it, by pixels to the right and down. */
export function turnedByHand(view: SpaceView, dx: number, dy: number, height: number): SpaceView {
  if (view.holds === "eye") {
    // As in the middle of the picture; a very wide one would whirl.
    const each = Math.min(2, unitsAt(view, 1, 1)) / Math.max(1, height);
    return turned(view, dx * each, -dy * each);
  }
  const each = Math.PI / Math.max(1, height);
  return turned(view, -dx * each, dy * each);
}

/** Shifted so that the target goes with the hand. */
export function panned(view: SpaceView, dx: number, dy: number, height: number): SpaceView {
  const unit = unitsAt(view, view.distance, height);
  const { right, up } = axesOf(view);
  return { ...view, target: add(add(view.target, right, -dx * unit), up, dy * unit) };
}

/** Everything looks `factor` times larger: the eye comes nearer, or, where it stays, sees a smaller angle. */
export function neared(view: SpaceView, factor: number, ball: Ball | null): SpaceView {
  if (view.holds === "eye") {
    const slope = Math.tan(view.angle / 2) / factor;
    return withAngle(view, 2 * Math.atan(slope));
  }
  const radius = ball && ball.radius > 0 ? ball.radius : 1;
  const distance = Math.min(FARTHEST * radius, Math.max(NEAREST * radius, view.distance / factor));
  return { ...view, distance };
}

export function withAngle(view: SpaceView, angle: number): SpaceView {
  return { ...view, angle: Math.min(MOST_ANGLE, Math.max(LEAST_ANGLE, angle)) };
}

/** Eye and target gone along together, in units of space: to the right, up the page, and ahead. */
export function flown(view: SpaceView, right: number, up: number, ahead: number): SpaceView {
  const axes = axesOf(view);
  const target = add(add(add(view.target, axes.right, right), axes.up, up), axes.ahead, ahead);
  return { ...view, target };
}

/** How steeply the picture opens to the side and upwards, less its margin. */
function slopesOf(angle: number, aspect: number): [number, number] {
  const slope = Math.tan(angle / 2) / MARGIN;
  return [slope * aspect, slope];
}

/** Where points are as the eye has them: to the right, up, and away. */
function seenBy(view: SpaceView, points: readonly Point3[]): Point3[] {
  const { right, up, ahead } = axesOf(view);
  const eye = eyeOf(view);
  return points.map((point) => {
    const p = minus(point, eye);
    return [dot(p, right), dot(p, up), dot(p, ahead)];
  });
}

/** Whether all points are in the picture, `aspect` times as wide as it is high, and before the eye. */
export function showsAll(view: SpaceView, points: readonly Point3[], aspect: number): boolean {
  const slope = Math.tan(view.angle / 2);
  return seenBy(view, points).every(
    ([x, y, z]) => z > 0 && Math.abs(x) <= slope * aspect * z && Math.abs(y) <= slope * z,
  );
}

/** The nearest place, from the side from which it is seen now, that has all points in the picture. */
export function wholeView(view: SpaceView, points: readonly Point3[], aspect: number): SpaceView {
  const angle = view.angle > USUAL_ANGLE * 2 ? USUAL_ANGLE : view.angle;
  const { holds: _, ...rest } = view;
  const seen = seenBy(view, points);
  // Each point asks for a distance: from its own side of the picture, the farther it lies beside the eye.
  const ask = (side: 0 | 1, slope: number) => {
    const plus = Math.max(...seen.map((p) => p[side] / slope - p[2]));
    const minus = Math.max(...seen.map((p) => -p[side] / slope - p[2]));
    return { back: (plus + minus) / 2, shift: (slope * (plus - minus)) / 2 };
  };
  const [across, upwards] = slopesOf(angle, aspect);
  const [x, y] = [ask(0, across), ask(1, upwards)];
  const back = Math.max(x.back, y.back);
  const { right, up, ahead } = axesOf(view);
  const eye = add(add(add(eyeOf(view), right, x.shift), up, y.shift), ahead, -back);
  // What is looked at lies in their midst, so that the view turns about them.
  const depths = seen.map((p) => p[2] + back);
  const distance = Math.max((Math.min(...depths) + Math.max(...depths)) / 2, 1e-6);
  return aimed({ ...rest, angle, distance }, eye);
}

/** From the origin, where the papers have their eye, towards the middle of the ball. */
export function fromOrigin(view: SpaceView, ball: Ball): SpaceView {
  const [x, y, z] = ball.centre;
  const distance = Math.hypot(x, y, z);
  const near = distance < 1e-6 * Math.max(1e-9, ball.radius);
  // Where the middle is the origin any way to look will do: the one of now.
  const next: SpaceView = near
    ? { ...view, distance: Math.max(ball.radius, 1e-3), holds: "eye" }
    : {
        ...view,
        turn: Math.atan2(-x, y) + 0,
        tilt: -Math.asin(Math.min(1, Math.max(-1, z / distance))) + 0,
        distance,
        holds: "eye",
      };
  return aimed(next, [0, 0, 0]);
}

/** How much of a ball lies before the eye. */
export function sightOf(view: SpaceView, ball: Ball): "before" | "around" | "behind" {
  const towards = minus(ball.centre, eyeOf(view));
  const depth = dot(towards, axesOf(view).ahead);
  if (depth <= -ball.radius) return "behind";
  return Math.hypot(...towards) < ball.radius ? "around" : "before";
}

/** A place of the picture, in pixels from its upper left, and how deep before the eye it is. */
export interface Pixel {
  x: number;
  y: number;
  depth: number;
}

/** Where a point is seen in a picture of this size; null for what is not before the eye. */
export function projected(
  view: SpaceView,
  point: Point3,
  { width, height }: { width: number; height: number },
): Pixel | null {
  const [[x, y, depth]] = seenBy(view, [point]) as [Point3];
  if (!(depth > 1e-6 * view.distance)) return null;
  const unit = unitsAt(view, depth, height);
  return { x: width / 2 + x / unit, y: height / 2 - y / unit, depth };
}

/** How deep before the eye a point lies. */
export function depthOf(view: SpaceView, point: Point3): number {
  return dot(minus(point, eyeOf(view)), axesOf(view).ahead);
}

/** What goes with a hand in the plane of the picture, at a depth before the eye. */
export function shiftByHand(view: SpaceView, dx: number, dy: number, depth: number, height: number): Point3 {
  const unit = unitsAt(view, depth, height);
  const { right, up } = axesOf(view);
  return add(add([0, 0, 0], right, dx * unit), up, -dy * unit);
}
