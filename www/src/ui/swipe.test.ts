import { beforeEach, expect, it, vi } from "vitest";
import { waitForSwipes } from "./swipe";

/** A range input on a page: the page hears of everything first, and may keep it from the input. */
class Slider extends EventTarget {
  type = "range";
  value = "0.9";
}
vi.stubGlobal("HTMLInputElement", Slider);

let page: EventTarget;
let slider: Slider;
let told: string[];

function fire(type: string, more: object = {}): void {
  const event = new Event(type, { bubbles: true });
  for (const [key, value] of Object.entries({ target: slider, pointerType: "touch", pointerId: 1, ...more }))
    Object.defineProperty(event, key, { value });
  page.dispatchEvent(event);
  if (!event.cancelBubble && type === "input") told.push(slider.value);
}
const finger = (type: string, clientX: number, clientY: number, more: object = {}) =>
  fire(`pointer${type}`, { clientX, clientY, ...more });
/** As the browser moves the thumb. */
const thumb = (value: string) => {
  slider.value = value;
  fire("input");
};

beforeEach(() => {
  page = new EventTarget();
  slider = new Slider();
  told = [];
  vi.spyOn(slider, "dispatchEvent").mockImplementation((event) => {
    fire(event.type);
    return true;
  });
  waitForSwipes(page);
});

it("leaves the value as it was where the page is scrolled", () => {
  finger("down", 100, 300);
  thumb("0.58");
  expect(slider.value).toBe("0.9");
  finger("move", 102, 280);
  thumb("0.59");
  finger("cancel", 102, 270);
  expect([told, slider.value]).toEqual([[], "0.9"]);
});

it("leaves it where the page has nowhere to scroll to", () => {
  finger("down", 100, 300);
  thumb("0.58");
  finger("move", 102, 280);
  finger("move", 160, 280);
  finger("up", 160, 280);
  expect([told, slider.value]).toEqual([[], "0.9"]);
});

it("follows a finger that goes sideways", () => {
  finger("down", 100, 300);
  thumb("0.58");
  finger("move", 103, 301);
  thumb("0.59");
  expect(told).toEqual([]);
  finger("move", 120, 303);
  thumb("0.65");
  finger("move", 121, 400);
  thumb("0.66");
  finger("up", 121, 400);
  expect(told).toEqual(["0.65", "0.66"]);
});

it("goes to where it was tapped", () => {
  finger("down", 100, 300);
  thumb("0.58");
  finger("up", 101, 300);
  expect([told, slider.value]).toEqual([["0.58"], "0.58"]);
});

it("does not wait for a mouse, nor for keys", () => {
  finger("down", 100, 300, { pointerType: "mouse" });
  thumb("0.58");
  finger("up", 100, 300, { pointerType: "mouse" });
  thumb("0.57");
  expect(told).toEqual(["0.58", "0.57"]);
});
