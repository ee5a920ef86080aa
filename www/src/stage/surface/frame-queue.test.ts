import { beforeEach, describe, expect, it, vi } from "vitest";
import { FrameQueue, type Quality } from "./frame-queue";

interface Order {
  request: string;
  quality: Quality;
  lane: number;
  answer: (frame?: string | null) => Promise<void>;
}

let orders: Order[] = [];
let shown: string[] = [];
let dropped: string[] = [];

function queue(lanes = 2): FrameQueue<string, string> {
  return new FrameQueue<string, string>({
    lanes,
    draw: (request, quality, lane) =>
      new Promise((resolve, reject) => {
        const answer = (frame: string | null = `${request} ${quality}`) => {
          if (frame === null) reject(new Error("no"));
          else resolve(frame);
          return vi.advanceTimersByTimeAsync(0).then(() => {});
        };
        orders.push({ request, quality, lane, answer });
      }),
    show: (frame) => shown.push(frame ?? "nothing"),
    drop: (frame) => dropped.push(frame),
  });
}

const asked = () => orders.map(({ request, quality, lane }) => `${request} ${quality} ${lane}`);

beforeEach(() => {
  vi.useFakeTimers();
  [orders, shown, dropped] = [[], [], []];
});

describe("frames that are asked for anew all the time", () => {
  it("are drawn two at once, and of those that wait the latest alone", async () => {
    const frames = queue();
    for (const request of ["a", "b", "c", "d"]) frames.ask(request);
    expect(asked()).toEqual(["a moving 0", "b moving 1"]);
    await orders[0]?.answer();
    expect(asked().slice(2)).toEqual(["d moving 0"]);
    expect(shown).toEqual(["a moving"]);
  });

  it("are shown in order: one that comes after a later one is dropped", async () => {
    const frames = queue();
    frames.ask("a");
    frames.ask("b");
    await orders[1]?.answer();
    await orders[0]?.answer();
    expect(shown).toEqual(["b moving"]);
    expect(dropped).toEqual(["a moving"]);
  });

  it("are drawn complete when nothing has changed for a moment, and not before", async () => {
    const frames = queue();
    frames.ask("a");
    await orders[0]?.answer();
    await vi.advanceTimersByTimeAsync(50);
    frames.ask("b");
    await vi.advanceTimersByTimeAsync(50);
    expect(asked()).toEqual(["a moving 0", "b moving 0"]);
    await orders[1]?.answer();
    await vi.advanceTimersByTimeAsync(100);
    expect(asked().slice(2)).toEqual(["b complete 0"]);
    expect(frames.complete).toBe(false);
    await orders[2]?.answer();
    expect(frames.complete).toBe(true);
    await vi.advanceTimersByTimeAsync(1000);
    expect(orders).toHaveLength(3);
  });

  it("go on beside a complete picture, which is dropped when it comes too late", async () => {
    const frames = queue();
    frames.ask("a");
    await orders[0]?.answer();
    await vi.advanceTimersByTimeAsync(100);
    frames.ask("b");
    expect(asked()).toEqual(["a moving 0", "a complete 0", "b moving 1"]);
    await orders[2]?.answer();
    await orders[1]?.answer();
    expect(shown).toEqual(["a moving", "b moving"]);
    expect(dropped).toEqual(["a complete"]);
    expect(frames.complete).toBe(false);
  });

  it("that cannot be drawn hold nothing up", async () => {
    const frames = queue(1);
    frames.ask("a");
    await orders[0]?.answer(null);
    await vi.advanceTimersByTimeAsync(100);
    await orders[1]?.answer(null);
    expect(shown).toEqual(["nothing", "nothing"]);
    expect(frames.complete).toBe(true);
    frames.ask("b");
    expect(asked().at(-1)).toBe("b moving 0");
  });

  it("are not shown once all is closed", async () => {
    const frames = queue();
    frames.ask("a");
    frames.close();
    await orders[0]?.answer();
    expect([shown, dropped]).toEqual([[], ["a moving"]]);
  });
});
