import { beforeEach, describe, expect, it, vi } from "vitest";
import { Lane, type Order } from "./lane";
import type { Answer, Ask, WorkerLike } from "./task";

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

/** Until the module is there. */
const fetched = () => vi.advanceTimersByTimeAsync(0);

/** A lane whose first worker is ready, with these orders. */
async function laneWith(...orders: Order[]): Promise<Lane> {
  const lane = new Lane(spawn, module);
  for (const one of orders) lane.give(one);
  await fetched();
  workers[0]?.say({ type: "ready" });
  return lane;
}

const runs = (worker: Fake | undefined) =>
  worker?.heard.flatMap((ask) => (ask.type === "run" ? [ask.id] : []));

beforeEach(() => {
  workers = [];
  vi.useFakeTimers();
});

describe("a lane", () => {
  it("starts one worker when it is first needed, gives it one task after the other and hands on what it says", async () => {
    const [first, second] = [order(1), order(2)];
    const lane = new Lane(spawn, module);
    expect(workers).toHaveLength(0);
    lane.give(first);
    lane.give(second);
    await fetched();
    expect(workers).toHaveLength(1);
    expect(workers[0]?.heard.map((ask) => ask.type)).toEqual(["start"]);
    workers[0]?.say({ type: "ready" });
    expect(runs(workers[0])).toEqual([1]);
    workers[0]?.say({ type: "done", id: 1, result: "one", milliseconds: 1 });
    expect(runs(workers[0])).toEqual([1, 2]);
    workers[0]?.say({ type: "progress", id: 2, value: 0.5 });
    workers[0]?.say({ type: "failed", id: 2, error: { code: "no", message: "No." }, fatal: false });
    expect(second.told).toEqual([0.5]);
    await expect(first.outcome).resolves.toBe("one");
    await expect(second.outcome).rejects.toMatchObject({ code: "no" });
  });

  it("ends a worker that does not stop, and what waited is done by the next", async () => {
    const [first, second] = [order(1), order(2)];
    const lane = await laneWith(first, second);
    lane.stop(1);
    await expect(first.outcome).rejects.toMatchObject({ code: "stopped" });
    expect(workers[0]?.heard.at(-1)).toEqual({ type: "stop", id: 1 });
    await vi.advanceTimersByTimeAsync(10_000);
    expect(workers[0]?.ended).toBe(true);
    workers[1]?.say({ type: "ready" });
    expect(runs(workers[1])).toEqual([2]);
    workers[1]?.say({ type: "done", id: 2, result: null, milliseconds: 1 });
    await expect(second.outcome).resolves.toBe(null);
  });

  it("leaves a worker alone that nothing waits for, until something does", async () => {
    const lane = await laneWith(order(1));
    lane.stop(1);
    vi.advanceTimersByTime(10_000);
    expect(workers[0]?.ended).toBe(false);
    lane.give(order(2));
    expect(workers[0]?.ended).toBe(true);
  });

  it("leaves a worker alone that stops when it is told", async () => {
    const lane = await laneWith(order(1), order(2));
    lane.stop(1);
    workers[0]?.say({ type: "failed", id: 1, error: { code: "stopped", message: "" }, fatal: false });
    vi.advanceTimersByTime(10_000);
    expect(workers[0]?.ended).toBe(false);
  });

  it("never takes a worker for dead that is slow to start", async () => {
    const lane = new Lane(spawn, module);
    const [first, second] = [order(1), order(2)];
    lane.give(first);
    await fetched();
    lane.stop(1);
    lane.give(second);
    await expect(first.outcome).rejects.toMatchObject({ code: "stopped" });
    vi.advanceTimersByTime(60_000);
    expect(workers[0]?.ended).toBe(false);
    expect(runs(workers[0])).toEqual([]);
    workers[0]?.say({ type: "ready" });
    expect(runs(workers[0])).toEqual([2]);
  });

  it("starts anew after a trap", async () => {
    const [first, second] = [order(1), order(2)];
    await laneWith(first, second);
    workers[0]?.say({ type: "failed", id: 1, error: { code: "trap", message: "Trap." }, fatal: true });
    await expect(first.outcome).rejects.toMatchObject({ code: "trap" });
    await fetched();
    workers[1]?.say({ type: "ready" });
    expect(runs(workers[1])).toEqual([2]);
  });

  it("asks once more where a worker died, and no more often", async () => {
    const first = order(1);
    await laneWith(first);
    for (const died of [0, 1]) {
      workers[died]?.onerror?.({} as ErrorEvent);
      await fetched();
      workers[died + 1]?.say({ type: "ready" });
    }
    expect(workers.map(runs)).toEqual([[1], [1]]);
    await expect(first.outcome).rejects.toMatchObject({ code: "worker-lost" });
  });

  it("does not ask again for what was handed over", async () => {
    const first = { ...order(1), transfer: [new ArrayBuffer(1)] };
    await laneWith(first);
    workers[0]?.onerror?.({} as ErrorEvent);
    await fetched();
    expect(workers).toHaveLength(1);
    await expect(first.outcome).rejects.toMatchObject({ code: "worker-lost" });
  });

  it("gives up where no worker comes up", async () => {
    const lane = new Lane(spawn, module);
    const [first, second] = [order(1), order(2)];
    lane.give(first);
    await fetched();
    workers[0]?.onerror?.({} as ErrorEvent);
    await fetched();
    expect(workers).toHaveLength(1);
    await expect(first.outcome).rejects.toMatchObject({ code: "worker-lost" });
    lane.give(second);
    await fetched();
    workers[1]?.say({ type: "unable", error: { code: "old", message: "Too old." } });
    await expect(second.outcome).rejects.toMatchObject({ code: "old" });
  });

  it("does not ask for what was called off before the module was there", async () => {
    let come: (module: WebAssembly.Module) => void = () => {};
    const lane = new Lane(spawn, () => new Promise((resolve) => (come = resolve)));
    const first = order(1);
    lane.give(first);
    lane.stop(1);
    come({} as WebAssembly.Module);
    await fetched();
    expect(workers).toHaveLength(0);
    await expect(first.outcome).rejects.toMatchObject({ code: "stopped" });
  });

  it("passes on that the module could not be had", async () => {
    const lane = new Lane(spawn, () => Promise.reject({ code: "offline", message: "Offline." }));
    const first = order(1);
    lane.give(first);
    await expect(first.outcome).rejects.toMatchObject({ code: "offline" });
  });
});
