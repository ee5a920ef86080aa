/** What hands, keys and buttons of the stage do. */

import { notify, wordsOf } from "#document/notice";
import { moveObject } from "#document/space/edits";
import { lookingAround, setView, space, spaceFrame, spaceView } from "#document/space/space";
import { about3, scale3, shift3 } from "#geometry/maps/affine3";
import type { MapRow3, SpaceView } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "../messages";
import { axesOf, depthOf, eyeOf, fromOrigin, shiftByHand, showsAll, wholeView } from "./camera";
import { chosenBall, samples, sight } from "./sight";
import { stageSize } from "./state";

/** Radians a pixel where the hand turns an object: the width of a phone is a full turn. */
const TURN_PER_PIXEL = (2 * Math.PI) / 640;
const SCALE_PER_PIXEL = 0.006;

const aspect = () => stageSize.peek().width / Math.max(1, stageSize.peek().height);

export function changeView(change: (view: SpaceView) => SpaceView): void {
  const view = spaceView.peek();
  if (!view) return;
  const after = change(view);
  if (after !== view) setView(after);
}

/** All of what there is at this moment. Where what the tool shows by itself has all of it, that is it. */
export function showWhole(): void {
  const now = space.peek();
  const view = spaceView.peek();
  const points = samples();
  if (!now || !view || points.length === 0) return;
  const plain = solid.defaultView(now);
  const own = showsAll(plain, points, aspect());
  const whole = own && !spaceFrame.peek()?.view ? null : wholeView(own ? plain : view, points, aspect());
  // Points of what is very large or small are not to be had.
  if (!setView(whole)) setView(null);
}

/** Where the papers have it. */
export function goToOrigin(): void {
  const ball = sight.peek()?.ball;
  if (ball) changeView((view) => fromOrigin(view, ball));
}

/** As the time line has it. */
export function backToFlight(): void {
  if (lookingAround.peek()) setView(null);
}

/** What turns about the target turns about the eye, and the other way round: the picture stays as it is. */
export function holdEye(hold: boolean): void {
  changeView(({ holds: _, ...view }) => (hold ? { ...view, holds: "eye" } : view));
}

type ObjectHand = "turn" | "move" | "scale";

/** The chosen object, by as many pixels of a hand: to the right and down. False where that cannot be. */
export function handObject(by: ObjectHand, dx: number, dy: number, gesture: string): boolean {
  const view = spaceView.peek();
  const ball = chosenBall();
  if (!view || !ball) return false;
  try {
    moveObject(transformOf(by, view, ball.centre, dx, dy), { gesture });
    return true;
  } catch (problem) {
    notify({ kind: "error", text: messages.objectUnchanged(wordsOf(problem)) });
    return false;
  }
}

function transformOf(
  by: ObjectHand,
  view: SpaceView,
  centre: [number, number, number],
  dx: number,
  dy: number,
): MapRow3 {
  if (by === "turn") {
    const { right, up } = axesOf(view);
    const across = solid.turning3(up, dx * TURN_PER_PIXEL, centre);
    const over = solid.turning3(right, dy * TURN_PER_PIXEL, centre);
    return solid.compose3(over, across);
  }
  if (by === "move") {
    const depth = depthOf(view, centre);
    // What lies behind the eye moves as what is looked at does.
    const at = depth > 1e-6 * view.distance ? depth : view.distance;
    return shift3(shiftByHand(view, dx, dy, at, stageSize.peek().height));
  }
  const factor = Math.exp((dx - dy) * SCALE_PER_PIXEL);
  return about3(scale3([factor, factor, factor]), centre);
}

/** One step of `flown`: a part of how far away things are. */
export function flightStep(view: SpaceView): number {
  const radius = sight.peek()?.ball.radius ?? view.distance;
  return 0.05 * Math.min(view.distance, 2 * radius);
}

/** Whether the eye is where the papers have it. */
export function atOrigin(view: SpaceView): boolean {
  return Math.hypot(...eyeOf(view)) <= 1e-9 * Math.max(1, view.distance);
}
