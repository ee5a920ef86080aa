import { beforeEach, expect, it, vi } from "vitest";
import { screen } from "#geometry/coordinates";
import { attachGrip, type Grip } from "./grip";

const endGesture = vi.hoisted(() => vi.fn());
vi.mock("#document/scene", () => ({ endGesture }));

/** A knob of a drawing whose upper left is at (10, 20) of the window. */
class Knob extends EventTarget {
  readonly ownerSVGElement = { getBoundingClientRect: () => ({ left: 10, top: 20 }) };
  readonly setPointerCapture = vi.fn();
  fire(type: string, more: object = {}): Event {
    const event = Object.assign(new Event(type, { cancelable: true, bubbles: true }), { button: 0 }, more);
    this.dispatchEvent(event);
    return event;
  }
  /** In CSS pixels of the drawing. */
  point(type: string, x: number, y: number, altKey = false, button = 0): void {
    this.fire(`pointer${type}`, { pointerId: 7, clientX: x + 10, clientY: y + 20, altKey, button });
  }
}

const grip = {
  take: vi.fn<Grip["take"]>(),
  moveTo: vi.fn<Grip["moveTo"]>(),
  key: vi.fn<Grip["key"]>(),
  focus: vi.fn<() => void>(),
};

function attached() {
  const knob = new Knob();
  return { knob, stop: attachGrip(knob as unknown as SVGElement, () => grip) };
}

beforeEach(() => {
  vi.resetAllMocks();
  grip.take.mockReturnValue(screen(100, 50));
});

it("follows the pointer from where it was taken, without a jump, until it is let go", () => {
  const { knob } = attached();
  knob.point("move", 90, 90);
  knob.point("down", 103, 48);
  knob.point("move", 113, 50);
  knob.point("move", 103, 48, true);
  expect(endGesture).not.toHaveBeenCalled();
  knob.point("up", 103, 48);
  knob.point("move", 0, 0);
  expect(grip.moveTo.mock.calls).toEqual([
    [screen(110, 52), false],
    [screen(100, 50), true],
  ]);
  expect(knob.setPointerCapture.mock.calls).toEqual([[7]]);
  expect(endGesture).toHaveBeenCalledTimes(1);
});

it("lets go where the pointer is taken away", () => {
  const { knob } = attached();
  knob.point("down", 100, 50);
  knob.fire("pointercancel");
  knob.point("move", 0, 0);
  expect(grip.moveTo).not.toHaveBeenCalled();
  expect(endGesture).toHaveBeenCalledTimes(1);
});

it("is not moved by another button, nor where it is gone", () => {
  const { knob } = attached();
  knob.point("down", 100, 50, false, 2);
  expect(grip.take).not.toHaveBeenCalled();
  grip.take.mockReturnValue(null);
  knob.point("down", 100, 50);
  knob.point("move", 0, 0);
  knob.point("up", 0, 0);
  expect(grip.moveTo).not.toHaveBeenCalled();
  expect(knob.setPointerCapture).not.toHaveBeenCalled();
  expect(endGesture).not.toHaveBeenCalled();
});

it("keeps its own keys from everybody else, and leaves the others", () => {
  const { knob } = attached();
  grip.key.mockReturnValueOnce(true);
  const own = knob.fire("keydown");
  const other = knob.fire("keydown");
  expect([own, other].map((event) => [event.defaultPrevented, event.cancelBubble])).toEqual([
    [true, true],
    [false, false],
  ]);
});

it("ends a step of undo when the key comes up, and when the focus goes", () => {
  const { knob } = attached();
  knob.fire("keyup");
  expect(endGesture).toHaveBeenCalledTimes(1);
  knob.fire("focus");
  expect(grip.focus).toHaveBeenCalledTimes(1);
  knob.fire("blur");
  expect(endGesture).toHaveBeenCalledTimes(2);
});

it("hears nothing once it is told to stop", () => {
  const { knob, stop } = attached();
  stop();
  knob.point("down", 100, 50);
  knob.fire("keydown");
  knob.fire("blur");
  expect(grip.take).not.toHaveBeenCalled();
  expect(grip.key).not.toHaveBeenCalled();
  expect(endGesture).not.toHaveBeenCalled();
});
