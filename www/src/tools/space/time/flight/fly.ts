import { announce } from "#document/notice";
import { reducedMotion } from "#document/preferences";
import { changeTimeline } from "#document/space/edits";
import { spaceFrame, spaceView, timeline } from "#document/space/space";
import type { Point3 } from "#wasm/api";
import { solid } from "#wasm/space";
import { pauseSpace, presentSpace } from "../clock";
import { attempt } from "../keys/keys";
import * as messages from "../messages";
import { secondsWords } from "../words";
import { aroundOf, type Ball, throughOf, withFlight } from "./flight";

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
