/** Ready flights of the eye. */

import { announce } from "#document/notice";
import { reducedMotion } from "#document/preferences";
import { changeTimeline, SAME_KEY_S } from "#document/space/edits";
import { spaceFrame, spaceView, timeline } from "#document/space/space";
import type { Point3, SpaceKey, SpaceTimeline, SpaceView } from "#wasm/api";
import { solid } from "#wasm/space";
import { pauseSpace, presentSpace } from "../clock";
import { attempt } from "../keys/keys";
import * as messages from "../messages";
import { MOST_KEYS, rounded } from "../time-edits";
import { secondsWords } from "../time-text";

/** A ball around all there is. */
interface Ball {
  centre: Point3;
  radius: number;
  /** Where most of it stands. Default: the centre. */
  amid?: Point3;
}

export const FLIGHT_SECONDS = 12;
const TURN = 2 * Math.PI;
/** Of the way to the middle: less, and the eye is in it. */
const OUTSIDE = 1.15;

/** Where the eye of a view is. */
export function eyeOf({ target, distance, turn, tilt }: SpaceView): Point3 {
  const flat = Math.cos(tilt);
  return [
    target[0] + distance * Math.sin(turn) * flat,
    target[1] - distance * Math.cos(turn) * flat,
    target[2] + distance * Math.sin(tilt),
  ];
}

/** The view from a point to another. */
export function lookingFrom(eye: Point3, target: Point3, angle: number): SpaceView {
  const [x, y, z] = [eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]];
  const distance = Math.hypot(x, y, z) || 1;
  return { target, distance, turn: Math.atan2(x, -y), tilt: Math.asin(z / distance), angle };
}

/** Once around: nearer and farther, lower and higher, and back to where it began. */
export function aroundOf(view: SpaceView, { centre, radius }: Ball): SpaceView[] {
  const { angle } = view;
  const fits = radius / Math.sin(Math.min(angle, 2) / 2);
  const tilt = Math.min(0.9, Math.max(0.15, view.tilt));
  const from = (part: number, near: number, lift: number): SpaceView => ({
    target: centre,
    distance: near * fits,
    turn: view.turn + part * TURN,
    tilt: tilt + lift,
    angle,
  });
  return [from(0, 1.05, 0), from(1 / 3, 0.62, -0.1), from(2 / 3, 0.85, 0.25), from(1, 1.05, 0)];
}

/**
 * From where the eye is into the scene, between what stands there, and up behind it; around what is seen from outside.
 */
export function throughOf(view: SpaceView, ball: Ball): SpaceView[] {
  const eye = eyeOf(view);
  const amid = ball.amid ?? ball.centre;
  const [x, y, z] = [amid[0] - eye[0], amid[1] - eye[1], amid[2] - eye[2]];
  const far = Math.hypot(x, y, z);
  const { centre, radius } = ball;
  const outside = Math.hypot(centre[0] - eye[0], centre[1] - eye[1], centre[2] - eye[2]) > OUTSIDE * radius;
  if (outside || far < 0.1 * radius) return swoopOf(view, ball);
  const flat = Math.hypot(x, y) || 1;
  // To the right of the way, level.
  const [rx, ry] = [y / flat, -x / flat];
  const at = (on: number, aside: number, up: number): Point3 => [
    eye[0] + on * x + aside * far * rx,
    eye[1] + on * y + aside * far * ry,
    eye[2] + on * z + up * far,
  ];
  const { angle } = view;
  return [
    lookingFrom(eye, at(1, 0, 0), angle),
    lookingFrom(at(0.42, 0.05, -0.03), at(1.05, 0, -0.03), angle),
    lookingFrom(at(0.71, -0.01, -0.04), at(1.4, 0.03, 0.04), angle),
    lookingFrom(at(0.5, 0.36, 0.24), at(1, 0, -0.02), angle),
  ];
}

/** Near by on the way around. */
function swoopOf(view: SpaceView, { centre, radius }: Ball): SpaceView[] {
  const around = aroundOf(view, { centre, radius });
  // Never so near that it would be in it.
  return around.map((key, i) => ({
    ...key,
    distance: i === 1 || i === 2 ? Math.max(1.8 * radius, 0.75 * key.distance) : key.distance,
    tilt: i === 1 ? key.tilt * 0.3 : key.tilt,
  }));
}

/** A time line on which the eye flies so. What its keys say of objects and of the morph stays. */
export function withFlight(line: SpaceTimeline | null, views: readonly SpaceView[]): SpaceTimeline {
  const held = (line?.keys ?? []).flatMap((key): SpaceKey[] => {
    const { view: _, ...rest } = key;
    return rest.moved || rest.maps || rest.t !== undefined ? [rest] : [];
  });
  // A flight alone goes once and ends where it began; other things keep their time.
  const base: Omit<SpaceTimeline, "keys"> =
    line && held.length > 0 ? line : { seconds: FLIGHT_SECONDS, loop: "once", course: "smooth" };
  const keys = [...held];
  views.forEach((view, i) => {
    const at = rounded((base.seconds * i) / Math.max(1, views.length - 1));
    const { holds: _, ...plain } = view;
    const there = keys.findIndex((key) => Math.abs(key.at - at) < SAME_KEY_S);
    const key = keys[there];
    if (key) keys[there] = { ...key, view: plain };
    else if (keys.length < MOST_KEYS) keys.push({ at, ease: "even", view: plain });
  });
  return {
    seconds: base.seconds,
    loop: base.loop,
    course: base.course,
    keys: keys.sort((a, b) => a.at - b.at),
  };
}

/** Makes keys of a flight through what there is, or around it, and plays it. */
export function fly(how: "through" | "around"): void {
  attempt(() => {
    const view = spaceView.peek();
    const ball = ballOfAll();
    if (!view || !ball) return;
    pauseSpace();
    const views = how === "around" ? aroundOf(view, ball) : throughOf(view, ball);
    changeTimeline(() => withFlight(timeline.peek(), views));
    const seconds = timeline.peek()?.seconds ?? 0;
    const hint = reducedMotion.peek() ? messages.pressPlayToSee : "";
    announce(messages.flightOf(secondsWords(seconds), views.length, hint));
    presentSpace();
  });
}

function ballOfAll(): Ball | null {
  const objects = spaceFrame.peek()?.objects.map(({ now }) => ({ maps: now }));
  if (!objects?.length) return null;
  const picture = new solid.SpacePicture(objects);
  try {
    // Of several objects the mean of their middles: a sky that is high up does not lift the flight.
    const middles = objects.map(({ maps }) => solid.facts3(maps).centre);
    const mean = (k: 0 | 1 | 2) => middles.reduce((sum, middle) => sum + middle[k], 0) / middles.length;
    const amid: Point3 = [mean(0), mean(1), mean(2)];
    return { centre: [...picture.centre] as Point3, radius: picture.radius, amid };
  } finally {
    picture.free();
  }
}
