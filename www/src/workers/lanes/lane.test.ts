import { beforeEach, describe, expect, it, vi } from "vitest";
import { Lane, type Order, type WorkerLike } from "./lane";
import type { Answer, Ask } from "./task";

class Fake implements WorkerLike {
  readonly heard: Ask[] = [];
  ended = false;
  onmessage: WorkerLike["onmessage"] = null;
  onerror: WorkerLike["onerror"] = null;
  postMessage(ask: Ask): void {
    this.heard.push(ask);
  }
  terminate(): void {
    this.ended = true;
  }
  say(answer: Answer): void {
    this.onmessage?.({ data: answer } as MessageEvent<Answer>);
  }
}

let workers: Fake[] = [];
const spawn = () => {
  const worker = new Fake();
  workers.push(worker);
  return worker;
};
const module = async () => ({}) as WebAssembly.Module;

function order(id: number): Order & { told: unknown[]; outcome: Promise<unknown> } {
  const told: unknown[] = [];
  let settle: Pick<Order, "resolve" | "reject"> | undefined;
  const outcome = new Promise((resolve, reject) => {
    settle = { resolve, reject };
  });
  outcome.catch(() => {});
  return {
    ask: { type: "run", id, name: "wake", args: {} },
    transfer: [],
    onProgress: (value) => told.push(value),
    resolve: (result) => settle?.resolve(result),
    reject: (problem) => settle?.reject(problem),
    told,
    outcome,
  };
}

beforeEach(() => {
  workers = [];
  vi.useFakeTimers();
});

describe("a lane", () => {
  it("starts one worker when it is first needed and hands on what it says", async () => {
    const lane = new Lane(spawn, module);
    expect(workers).toHaveLength(0);
    const [first, second] = [order(1), order(2)];
    await Promise.all([lane.give(first), lane.give(second)]);
    expect(workers).toHaveLength(1);
    expect(workers[0]?.heard.map((ask) => ask.type)).toEqual(["start", "run", "run"]);
    workers[0]?.say({ type: "progress", id: 2, value: 0.5 });
    workers[0]?.say({ type: "done", id: 1, result: "one" });
    workers[0]?.say({ type: "failed", id: 2, error: { code: "no", message: "No." }, fatal: false });
    expect(second.told).toEqual([0.5]);
    await expect(first.outcome).resolves.toBe("one");
    await expect(second.outcome).rejects.toMatchObject({ code: "no" });
  });

  it("says at once that something is stopped, and ends a worker that does not listen", async () => {
    const lane = new Lane(spawn, module);
    const [first, second] = [order(1), order(2)];
    await Promise.all([lane.give(first), lane.give(second)]);
    lane.stop(1);
    await expect(first.outcome).rejects.toMatchObject({ code: "stopped" });
    expect(workers[0]?.heard.at(-1)).toEqual({ type: "stop", id: 1 });
    vi.advanceTimersByTime(10_000);
    expect(workers[0]?.ended).toBe(true);
    await expect(second.outcome).rejects.toMatchObject({ code: "worker-lost" });
    const third = order(3);
    await lane.give(third);
    expect(workers).toHaveLength(2);
    workers[1]?.say({ type: "done", id: 3, result: null });
    await expect(third.outcome).resolves.toBe(null);
  });

  it("leaves a worker alone that stops when it is told", async () => {
    const lane = new Lane(spawn, module);
    await lane.give(order(1));
    lane.stop(1);
    workers[0]?.say({ type: "failed", id: 1, error: { code: "stopped", message: "" }, fatal: false });
    vi.advanceTimersByTime(10_000);
    expect(workers[0]?.ended).toBe(false);
  });

  it("starts anew after a trap", async () => {
    const lane = new Lane(spawn, module);
    const [first, second] = [order(1), order(2)];
    await Promise.all([lane.give(first), lane.give(second)]);
    workers[0]?.say({ type: "failed", id: 1, error: { code: "trap", message: "Trap." }, fatal: true });
    await expect(first.outcome).rejects.toMatchObject({ code: "trap" });
    await expect(second.outcome).rejects.toMatchObject({ code: "worker-lost" });
    await lane.give(order(3));
    expect(workers).toHaveLength(2);
  });

  it("does not ask for what was called off before the module was there", async () => {
    let come: (module: WebAssembly.Module) => void = () => {};
    const lane = new Lane(spawn, () => new Promise((resolve) => (come = resolve)));
    const first = order(1);
    const given = lane.give(first);
    lane.stop(1);
    come({} as WebAssembly.Module);
    await given;
    expect(workers).toHaveLength(0);
    await expect(first.outcome).rejects.toMatchObject({ code: "stopped" });
  });

  it("passes on that the module could not be had", async () => {
    const lane = new Lane(spawn, () => Promise.reject({ code: "offline", message: "Offline." }));
    const first = order(1);
    await lane.give(first);
    await expect(first.outcome).rejects.toMatchObject({ code: "offline" });
  });
});
