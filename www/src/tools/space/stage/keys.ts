/** Keys on the focused stage of space. */
import { endGesture } from "#document/scene";
import { hand } from "#document/space/space";
import { type KeyPress, latinKey } from "#ui/focus";
import { changeView, flightStep, handObject, showWhole } from "./actions";
import { flown, neared, panned, turned, withAngle } from "./camera";
import { sight } from "./sight";
import { stageSize } from "./state";

type StageCommand =
  /** As many steps to the right and down: whatever the hand does. */
  | { do: "hand" | "pan"; right: number; down: number }
  | { do: "near" | "angle"; factor: number }
  | { do: "fly"; right: number; up: number; ahead: number }
  | { do: "whole" };

const ARROWS: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
const FLIGHT: Record<string, readonly [number, number, number]> = {
  a: [-1, 0, 0],
  d: [1, 0, 0],
  q: [0, -1, 0],
  e: [0, 1, 0],
  s: [0, 0, -1],
  w: [0, 0, 1],
};
const FACTORS: Record<string, StageCommand> = {
  "+": { do: "near", factor: 1.15 },
  "=": { do: "near", factor: 1.15 },
  "-": { do: "near", factor: 1 / 1.15 },
  _: { do: "near", factor: 1 / 1.15 },
  ",": { do: "angle", factor: 1 / 1.08 },
  ".": { do: "angle", factor: 1.08 },
  "0": { do: "whole" },
};
const KEY_TURN = (5 * Math.PI) / 180;
const KEY_PIXELS = 24;
/** A key turns an object as far as it turns the view. */
const OBJECT_PIXELS = { turn: (5 / 360) * 640, move: KEY_PIXELS, scale: 10 };
const GESTURE = "space-keys";

export function stageCommand(press: KeyPress): StageCommand | null {
  if (press.ctrlKey || press.metaKey || press.altKey) return null;
  const arrow = ARROWS[press.key];
  if (arrow) return { do: press.shiftKey ? "pan" : "hand", right: arrow[0], down: arrow[1] };
  const way = FLIGHT[latinKey(press).toLowerCase()];
  if (way) {
    // Shift is for a closer look.
    const by = press.shiftKey ? 0.1 : 1;
    return { do: "fly", right: way[0] * by, up: way[1] * by, ahead: way[2] * by };
  }
  return FACTORS[press.key] ?? null;
}

/** True when the key was one of the stage's. */
export function stageKey(event: KeyboardEvent): boolean {
  const command = stageCommand(event);
  if (!command) return false;
  switch (command.do) {
    case "hand":
      byHand(command.right, command.down);
      break;
    case "pan": {
      const { height } = stageSize.peek();
      changeView((view) => panned(view, command.right * KEY_PIXELS, command.down * KEY_PIXELS, height));
      break;
    }
    case "near":
      changeView((view) => neared(view, command.factor, sight.peek()?.ball ?? null));
      break;
    case "angle":
      changeView((view) => withAngle(view, view.angle * command.factor));
      break;
    case "fly":
      changeView((view) => {
        const step = flightStep(view);
        return flown(view, command.right * step, command.up * step, command.ahead * step);
      });
      break;
    case "whole":
      showWhole();
      break;
  }
  return true;
}

/** The key is let go: what comes next is another step to undo. */
export function stageKeyUp(event: KeyboardEvent): void {
  if (hand.peek() !== "look" && event.key in ARROWS) endGesture();
}

function byHand(right: number, down: number): void {
  const by = hand.peek();
  if (by !== "look") {
    const pixels = OBJECT_PIXELS[by];
    handObject(by, right * pixels, down * pixels, GESTURE);
    return;
  }
  // As a hand that takes hold of what is seen, and the eye looks the way of the arrow where it stays.
  changeView((view) =>
    view.holds === "eye"
      ? turned(view, -right * KEY_TURN * 0.4, down * KEY_TURN * 0.4)
      : turned(view, -right * KEY_TURN, down * KEY_TURN),
  );
}
