import { describe, expect, it, vi } from "vitest";
import { CardQueue, type LocusCompute, type Plane } from "./locus-card";

vi.mock("../../pkg/renderer.js", () => ({}));

const plane = (width: number): Plane => ({ from: [], to: [], options: { width, height: 1 } });

/** A card that answers when it is told to. */
function slow() {
  const running: { width: number; end: (problem?: unknown) => void }[] = [];
  const run = (_: unknown, __: unknown, { width }: { width: number }) =>
    new Promise((resolve, reject) => {
      running.push({ width, end: (problem) => (problem ? reject(problem) : resolve({ width })) });
    });
  const free = vi.fn();
  return { card: { run, free } as unknown as LocusCompute, running, free };
}

/** A card that has these milliseconds to tell, one after the other. */
function timed(...milliseconds: number[]): LocusCompute {
  const run = async (_: unknown, __: unknown, { width, height }: { width: number; height: number }) => ({
    width,
    height,
    milliseconds: milliseconds.shift(),
  });
  return { run } as unknown as LocusCompute;
}

const turn = () => new Promise((resolve) => setTimeout(resolve));

describe("CardQueue", () => {
  it("asks one after the other, and not for what is no longer wanted", async () => {
    const { card, running } = slow();
    const queue = new CardQueue(card, vi.fn());
    let latest = 0;
    const answers = [1, 2, 3].map((width) => {
      latest = width;
      return queue.ask(plane(width), () => latest === width || width === 1);
    });
    await turn();
    expect(running.map(({ width }) => width)).toEqual([1]);
    running[0]?.end();
    await turn();
    expect(running.map(({ width }) => width)).toEqual([1, 3]);
    running[1]?.end();
    expect(await Promise.all(answers)).toEqual([{ width: 1 }, null, { width: 3 }]);
  });

  it("knows how quick it is at its best, and forgets that slowly", async () => {
    const queue = new CardQueue(timed(10, 100, 100, 9, 1000), vi.fn());
    const paces: number[] = [];
    for (const height of [100, 100, 100, 100, 1]) {
      await queue.ask({ from: [], to: [], options: { width: 200, height } }, () => true);
      paces.push(1000 * queue.pace);
    }
    for (const [k, pace] of [0.5, 0.75, 1.125, 0.45, 0.45].entries()) expect(paces[k]).toBeCloseTo(pace, 9);
  });

  it("leaves to the workers what is not for it, and is not asked again after any other failure", async () => {
    const { card, running, free } = slow();
    const lost = vi.fn();
    const queue = new CardQueue(card, lost);
    const fine = queue.ask(plane(1), () => true);
    await turn();
    running[0]?.end({ code: "single-fine", message: "too fine" });
    expect(await fine).toBeNull();
    expect(lost).not.toHaveBeenCalled();
    const failed = queue.ask(plane(2), () => true);
    await turn();
    running[1]?.end({ code: "device-lost", message: "gone" });
    expect(await failed).toBeNull();
    expect(lost).toHaveBeenCalledOnce();
    expect(free).toHaveBeenCalledOnce();
    expect(await queue.ask(plane(3), () => true)).toBeNull();
    expect(running).toHaveLength(2);
  });
});
