import { endGesture } from "#document/scene";
import { choose, hand } from "#document/space/space";
import { attachPanZoom } from "#ui/panZoom";
import { changeView, handObject, showWhole } from "./actions";
import { neared, panned, turnedByHand } from "./camera";
import { sight } from "./sight";
import { objectUnder, stageSize } from "./state";

type Doing = "look" | "pan" | "turn" | "move" | "scale";

let gestures = 0;

/** Drags, pinches and the wheel on the stage of space. Returns the end of it. */
export function attachGestures(element: HTMLElement): () => void {
  let doing: Doing = "pan";
  let gesture = "";
  /** What has not been shown yet: there are more events than frames. */
  let due: { dx: number; dy: number; factor: number } | null = null;
  let frame = 0;

  const height = () => stageSize.peek().height;

  const act = () => {
    cancelAnimationFrame(frame);
    frame = 0;
    if (!due) return;
    const { dx, dy, factor } = due;
    due = null;
    if (factor !== 1) changeView((view) => neared(view, factor, sight.peek()?.ball ?? null));
    if (dx === 0 && dy === 0) return;
    if (doing === "look") changeView((view) => turnedByHand(view, dx, dy, height()));
    else if (doing === "pan") changeView((view) => panned(view, dx, dy, height()));
    else handObject(doing, dx, dy, gesture);
  };
  const later = (dx: number, dy: number, factor = 1) => {
    const before = due ?? { dx: 0, dy: 0, factor: 1 };
    due = { dx: before.dx + dx, dy: before.dy + dy, factor: before.factor * factor };
    if (!frame) frame = requestAnimationFrame(act);
  };

  const end = attachPanZoom(element, {
    takes: ({ button }) => button <= 2,
    pan: later,
    zoom: (factor) => later(0, 0, factor),
    fit: showWhole,
    rest: act,
    begin(event, at) {
      if (event.button !== 0 || event.shiftKey) return null;
      doing = hand.peek();
      gesture = `space-hand-${++gestures}`;
      // What a hand is laid on is what it turns; beside everything, what was chosen before.
      const under = doing === "look" ? null : objectUnder(at.x, at.y);
      if (under !== null) choose(under);
      return {
        move: (_, now, before) => later(now.x - before.x, now.y - before.y),
        // A second finger is for the view, whatever the first one did.
        end() {
          act();
          if (doing !== "look") endGesture();
          doing = "pan";
        },
      };
    },
  });

  const listening = new AbortController();
  const { signal } = listening;
  // The right button shifts, and the middle one does not scroll.
  element.addEventListener("contextmenu", (event) => event.preventDefault(), { signal });
  element.addEventListener("mousedown", (event) => event.button === 1 && event.preventDefault(), { signal });
  return () => {
    end();
    cancelAnimationFrame(frame);
    listening.abort();
  };
}
