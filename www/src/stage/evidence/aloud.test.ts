import { signal } from "@preact/signals";
import { afterEach, beforeEach, expect, it, vi } from "vitest";

/** Anew for each test, as for each page. */
async function fresh() {
  vi.resetModules();
  const { announcement } = await import("#document/notice");
  return { announcement, ...(await import("./aloud")) };
}

const LONG = 10_000;

const text = signal("");
const moving = signal(false);
const told = () => ({ text: text.value, moving: moving.value });
let stop = () => {};
let announcement: { peek: () => string };
let sayAtRest: Awaited<ReturnType<typeof fresh>>["sayAtRest"];

beforeEach(async () => {
  ({ announcement, sayAtRest } = await fresh());
  vi.useFakeTimers();
  text.value = "In one piece";
  moving.value = false;
  stop = sayAtRest(told);
  vi.advanceTimersByTime(LONG);
});

afterEach(() => {
  stop();
  vi.useRealTimers();
});

it("leaves the first verdict to the page, and says another one", () => {
  expect(announcement.peek()).toBe("");
  text.value = "In pieces";
  expect(announcement.peek()).toBe("");
  vi.advanceTimersByTime(LONG);
  expect(announcement.peek()).toBe("In pieces");
});

it("waits while the picture moves, and leaves out what has passed", () => {
  moving.value = true;
  text.value = "In pieces";
  vi.advanceTimersByTime(LONG);
  expect(announcement.peek()).toBe("");
  text.value = "It touches";
  moving.value = false;
  vi.advanceTimersByTime(LONG);
  expect(announcement.peek()).toBe("It touches");
});

it("says nothing where it comes back to what was said, or is ended", () => {
  text.value = "In pieces";
  vi.advanceTimersByTime(1);
  text.value = "In one piece";
  vi.advanceTimersByTime(LONG);
  expect(announcement.peek()).toBe("");
  text.value = "In pieces";
  stop();
  vi.advanceTimersByTime(LONG);
  expect(announcement.peek()).toBe("");
});

it("says what another chip knows in place of the one before", () => {
  stop();
  text.value = "In pieces";
  stop = sayAtRest(told);
  vi.advanceTimersByTime(LONG);
  expect(announcement.peek()).toBe("In pieces");
});
