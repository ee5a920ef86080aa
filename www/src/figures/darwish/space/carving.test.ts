import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { PictureRequest } from "#workers/space/complete-picture";
import { Carving, COARSE, REST_MS } from "./carving";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

const SIZE = 400;

function stand(milliseconds: number) {
  const asked: { turn: number; width: number; called: "made" | "stopped" | null }[] = [];
  const carving = new Carving(
    (request, signal) =>
      new Promise((resolve, reject) => {
        const one: (typeof asked)[number] = { turn: request.view.turn, width: request.width, called: null };
        asked.push(one);
        signal.addEventListener("abort", () => {
          one.called ??= "stopped";
          reject({ code: "stopped", message: "" });
        });
        setTimeout(() => {
          if (one.called) return;
          one.called = "made";
          resolve({ width: request.width, turn: request.view.turn } as unknown as ImageData);
        }, milliseconds);
      }),
  );
  const painted: [turn: number, whole: boolean][] = [];
  const failed: unknown[] = [];
  const take = (turn: number) =>
    carving.take({ view: { turn }, width: SIZE, height: SIZE } as PictureRequest, {
      paint: (image, whole) => painted.push([(image as unknown as { turn: number }).turn, whole]),
      fail: (problem) => failed.push(problem),
    });
  return { carving, asked, painted, failed, take };
}

test("the first picture is carved coarsely, and then in full at once", async () => {
  const { take, asked, painted } = stand(30);
  take(1);
  await vi.advanceTimersByTimeAsync(70);
  expect(asked).toEqual([
    { turn: 1, width: SIZE / COARSE, called: "made" },
    { turn: 1, width: SIZE, called: "made" },
  ]);
  expect(painted).toEqual([
    [1, false],
    [1, true],
  ]);
});

test("while it moves there are coarse pictures, the latest in the end, and one in full at rest", async () => {
  const { take, asked, painted, failed } = stand(30);
  take(0);
  await vi.advanceTimersByTimeAsync(70);
  for (let turn = 1; turn <= 10; turn++) {
    take(turn);
    await vi.advanceTimersByTimeAsync(10);
  }
  await vi.advanceTimersByTimeAsync(REST_MS + 100);
  const coarse = asked.filter(({ width }) => width === SIZE / COARSE);
  expect(coarse.length).toBeGreaterThan(2);
  expect(coarse.length).toBeLessThan(10);
  expect(coarse.every(({ called }) => called === "made")).toBe(true);
  expect(painted.at(-2)).toEqual([10, false]);
  expect(painted.at(-1)).toEqual([10, true]);
  expect(failed).toEqual([]);
});

test("a full picture is given up as soon as something moves", async () => {
  const { take, asked, failed, painted } = stand(500);
  take(1);
  await vi.advanceTimersByTimeAsync(600);
  expect(asked.at(-1)).toEqual({ turn: 1, width: SIZE, called: null });
  take(2);
  expect(asked[1]?.called).toBe("stopped");
  expect(asked.at(-1)).toEqual({ turn: 2, width: SIZE / COARSE, called: null });
  await vi.advanceTimersByTimeAsync(2000);
  expect(asked.at(-1)).toEqual({ turn: 2, width: SIZE, called: "made" });
  expect(painted).toEqual([
    [1, false],
    [2, false],
    [2, true],
  ]);
  expect(failed).toEqual([]);
});

test("nothing comes after the end", async () => {
  const { take, carving, painted, asked } = stand(30);
  take(1);
  await vi.advanceTimersByTimeAsync(10);
  carving.end();
  await vi.advanceTimersByTimeAsync(1000);
  expect(painted).toEqual([]);
  expect(asked).toHaveLength(1);
});
