import { beforeEach, expect, it, vi } from "vitest";
import { attachPanZoom, type PanZoom, panZoomKey } from "./panZoom";

vi.stubGlobal("Element", class {});

class Stage extends EventTarget {
  readonly dataset: Record<string, string> = {};
  setPointerCapture(): void {}
  getBoundingClientRect = () => ({ left: 10, top: 20 });
  fire(type: string, more: object): void {
    this.dispatchEvent(
      Object.assign(new Event(type, { cancelable: true }), { button: 0, deltaMode: 0, deltaX: 0 }, more),
    );
  }
  /** In CSS pixels of the stage. */
  point(type: string, x: number, y: number, pointerId = 1): void {
    this.fire(`pointer${type}`, { pointerId, clientX: x + 10, clientY: y + 20 });
  }
}

let done: unknown[][] = [];
const picture: PanZoom = {
  pan: (dx, dy) => void done.push(["pan", dx, dy]),
  zoom: (factor, about) => void done.push(["zoom", Number(factor.toFixed(3)), about && [about.x, about.y]]),
  fit: () => void done.push(["fit"]),
  rest: () => void done.push(["rest"]),
};
const stage = (more: Partial<PanZoom> = {}) => {
  const element = new Stage();
  const end = attachPanZoom(element as unknown as HTMLElement, { ...picture, ...more });
  return { element, end };
};

beforeEach(() => {
  done = [];
  vi.useFakeTimers();
});

it("moves with the pointer until it is let go", () => {
  const { element, end } = stage();
  element.point("down", 0, 0);
  expect(element.dataset).toEqual({ dragging: "" });
  element.point("move", 3, 1);
  element.point("move", 5, 0);
  element.point("up", 5, 0);
  element.point("move", 9, 9);
  expect(done).toEqual([["pan", 3, 1], ["pan", 2, -1], ["rest"]]);
  expect(element.dataset).toEqual({});
  end();
  element.point("down", 0, 0);
  element.point("move", 3, 1);
  expect(done).toHaveLength(3);
});

it("keeps what is between two fingers between them, and ends what the first began", () => {
  const ended = vi.fn();
  const { element } = stage({
    begin: () => ({ move: (_, now) => void done.push(["stroke", now.x]), end: ended }),
  });
  element.point("down", 0, 0);
  element.point("move", 1, 0);
  element.point("down", 11, 0, 2);
  expect(ended.mock.calls).toEqual([[false]]);
  element.point("move", 21, 0, 2);
  expect(done).toEqual([
    ["stroke", 1],
    ["pan", 5, 0],
    ["zoom", 2, [11, 0]],
  ]);
  element.point("up", 1, 0);
  element.point("move", 22, 0, 2);
  expect(done.at(-1)).toEqual(["pan", 1, 0]);
  element.point("up", 22, 0, 2);
  expect(ended).toHaveBeenCalledOnce();
});

it("tells a tap from a drag, however it trembles", () => {
  const tapped = vi.fn();
  const { element } = stage({ flat: true, tap: ({ x }) => tapped(x) });
  element.point("down", 0, 0);
  element.point("move", 3, 40);
  element.point("up", 3, 40);
  expect([tapped.mock.calls, done]).toEqual([[[3]], [["rest"]]]);
  element.point("down", 0, 0);
  element.point("move", 6, 0);
  element.point("up", 6, 0);
  expect(tapped).toHaveBeenCalledOnce();
  expect(done.slice(1)).toEqual([["pan", 6, 0], ["rest"]]);
});

it("enlarges under the wheel, by pixels, lines and pinches of a touch pad, and then rests", () => {
  const { element } = stage();
  const at = { clientX: 14, clientY: 25 };
  element.fire("wheel", { deltaY: -100, ...at });
  element.fire("wheel", { deltaY: 10, deltaMode: 1, ...at });
  element.fire("wheel", { deltaY: -10, ctrlKey: true, ...at });
  expect(done).toEqual([1.174, 0.774, 1.105].map((factor) => ["zoom", factor, [4, 5]]));
  vi.advanceTimersByTime(1000);
  expect(done.slice(3)).toEqual([["rest"]]);
  const flat = stage({ flat: true });
  flat.element.fire("wheel", { deltaX: 8, deltaY: 2, ...at });
  expect(done.at(-1)).toEqual(["pan", -8, 0]);
});

it("leaves alone what is not for it, and shows all of it after two presses", () => {
  const { element } = stage({ takes: ({ button }) => button === 2 });
  element.point("down", 0, 0);
  element.point("move", 3, 1);
  element.fire("dblclick", {});
  expect(done).toEqual([]);
  element.fire("dblclick", { button: 2 });
  expect(done).toEqual([["fit"]]);
});

it("goes by keys", () => {
  const press = (key: string, more: object = {}, flat = false) =>
    panZoomKey({ key, ...more } as KeyboardEvent, { ...picture, flat });
  expect(["ArrowLeft", "+", "_", "0"].map((key) => press(key))).toEqual([true, true, true, true]);
  expect(press("ArrowDown", { shiftKey: true })).toBe(true);
  const asked = done.filter(([what]) => what !== "rest");
  expect(asked).toEqual([
    ["pan", 48, 0],
    ["zoom", 1.25, undefined],
    ["zoom", 0.8, undefined],
    ["fit"],
    ["pan", 0, -12],
  ]);
  expect([press("a"), press("0", { ctrlKey: true }), press("ArrowUp", {}, true)]).toEqual([
    false,
    false,
    false,
  ]);
});
