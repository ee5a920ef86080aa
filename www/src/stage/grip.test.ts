import { beforeEach, expect, it, vi } from "vitest";
import { screen } from "#geometry/coordinates";
import { attachGrip, type Grip } from "./grip";

const { endGesture, takeBack } = vi.hoisted(() => ({ endGesture: vi.fn(), takeBack: vi.fn() }));
vi.mock("#document/scene", () => ({ endGesture, takeBack }));

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

/** A picture in its pane, and two knobs over it: the pane hears first of what a finger does, and may stop it. */
class Place extends EventTarget {
  readonly dataset: Record<string, string> = {};
  readonly ownerSVGElement = { getBoundingClientRect: () => ({ left: 0, top: 0 }) };
  readonly setPointerCapture = vi.fn();
  readonly closest: (what: string) => unknown;
  constructor(closest: (what: string) => unknown) {
    super();
    this.closest = closest;
  }
}

function fingers() {
  vi.stubGlobal("Element", Place);
  vi.stubGlobal(
    "PointerEvent",
    class extends Event {
      constructor(type: string, told: object) {
        super(type);
        Object.assign(this, told);
      }
    },
  );
  const picture: Place = new Place((what) => (what === ".pane" ? pane : null));
  const pane = Object.assign(new Place(() => null), { querySelector: () => picture });
  const over = (what: string) => (what === ".pane" ? pane : what === "[data-handle]" ? {} : null);
  const knobs = [new Place(over), new Place(over)] as const;
  for (const knob of knobs) attachGrip(knob as unknown as SVGElement, () => grip);
  const told: unknown[] = [];
  picture.addEventListener("pointerdown", (event) => {
    const { pointerId, clientX, clientY } = event as PointerEvent;
    told.push([pointerId, clientX, clientY]);
    picture.dataset["dragging"] = "";
  });
  const put = (type: string, at: Place, pointerId: number, x: number, y: number) => {
    const more = { pointerId, pointerType: "touch", clientX: x, clientY: y, button: 0, target: at };
    const event = new Event(`pointer${type}`, { bubbles: true });
    for (const [key, value] of Object.entries(more)) Object.defineProperty(event, key, { value });
    pane.dispatchEvent(event);
    if (!event.cancelBubble) at.dispatchEvent(event);
  };
  return { picture, knobs, told, put };
}

it("leaves two fingers to the picture, and takes back what the first has changed", () => {
  for (const second of ["picture", "knob"]) {
    vi.resetAllMocks();
    grip.take.mockReturnValue(screen(100, 50));
    const { picture, knobs, told, put } = fingers();
    put("down", knobs[0], 1, 100, 50);
    put("move", knobs[0], 1, 110, 50);
    expect(grip.moveTo).toHaveBeenCalledTimes(1);
    put("down", second === "knob" ? knobs[1] : picture, 2, 200, 60);
    expect(takeBack).toHaveBeenCalledTimes(1);
    expect(told).toEqual([
      [1, 110, 50],
      [2, 200, 60],
    ]);
    put("move", knobs[0], 1, 120, 50);
    put("up", knobs[0], 1, 120, 50);
    expect(grip.moveTo).toHaveBeenCalledTimes(1);
    expect(grip.take).toHaveBeenCalledTimes(1);
    expect(endGesture).not.toHaveBeenCalled();
  }
});

it("is not taken by a second finger while the first moves the picture", () => {
  const { picture, knobs, told, put } = fingers();
  put("down", picture, 1, 10, 10);
  put("down", knobs[0], 2, 100, 50);
  expect(grip.take).not.toHaveBeenCalled();
  expect(told).toEqual([
    [1, 10, 10],
    [2, 100, 50],
  ]);
});

it("is a finger's own again when the one before was lifted", () => {
  const { picture, knobs, told, put } = fingers();
  put("down", knobs[0], 1, 100, 50);
  put("up", knobs[0], 1, 100, 50);
  put("down", picture, 2, 10, 10);
  expect(told).toEqual([[2, 10, 10]]);
  expect(takeBack).not.toHaveBeenCalled();
});
