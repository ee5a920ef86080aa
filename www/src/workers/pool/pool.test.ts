import { beforeEach, describe, expect, it, vi } from "vitest";
import { OnPage } from "../lanes/on-page";
import { performerOf } from "../lanes/performer";
import type { Answer, Ask, WorkerLike } from "../lanes/task";
import { Coalesce } from "./coalesce";
import { Pool } from "./pool";
import type { Channel, Job, Modules, Task } from "./protocol";

/** A worker that answers when told to. It hears what is called off when the task under way has ended. */
class FakeWorker implements WorkerLike<Modules> {
  onmessage: WorkerLike<Modules>["onmessage"] = null;
  onerror: WorkerLike<Modules>["onerror"] = null;
  terminated = false;
  work: { id: number; args: unknown }[] = [];
  stopped: number[] = [];

  postMessage(message: Ask<Modules>): void {
    if (message.type === "run") this.work.push(message);
    if (message.type === "stop") this.stopped.push(message.id);
  }

  terminate(): void {
    this.terminated = true;
  }

  say(answer: Answer): void {
    this.onmessage?.({ data: answer } as MessageEvent<Answer>);
  }

  finish(): void {
    const { id } = this.work.shift() ?? { id: -1 };
    this.say({ type: "done", id, result: new Uint8Array([id]), milliseconds: 1 });
    for (const { id: off } of this.work.filter((one) => this.stopped.includes(one.id))) {
      this.work = this.work.filter((one) => one.id !== off);
      this.say({ type: "failed", id: off, error: { code: "stopped", message: "" }, fatal: false });
    }
  }

  get names(): string[] {
    return this.work.map(({ args }) => (args as { n: string }).n);
  }

  die(): void {
    this.onerror?.({} as ErrorEvent);
  }
}

let workers: FakeWorker[];
const modules = {} as Modules;

function pool(count: number, more: Partial<ConstructorParameters<typeof Pool>[0]> = {}): Pool {
  const made = new Pool({
    count,
    modules,
    spawn: () => {
      const worker = new FakeWorker();
      workers.push(worker);
      return worker;
    },
    ...more,
  });
  for (const worker of workers) worker.say({ type: "ready" });
  return made;
}

/** A job of so many slices, with a record of what came of them. */
function job(channel: Channel, slices: number, priority = 1) {
  const log = { accepted: [] as unknown[], failed: [] as string[], done: 0 };
  let next = 0;
  const made: Job = {
    channel,
    priority: () => priority,
    next: () => (next < slices ? ({ kind: "plan", n: `${channel}${next++}` } as unknown as Task) : null),
    accept: (task) => void log.accepted.push((task as unknown as { n: string }).n),
    fail: (_, error) => void log.failed.push(error.code),
    done: () => void log.done++,
  };
  return { job: made, log };
}

beforeEach(() => {
  workers = [];
});

describe("Pool", () => {
  it("gives slices to all workers and ends the job once", () => {
    const p = pool(2);
    const { job: j, log } = job("locus", 5);
    p.submit(j);
    expect(workers.map((w) => w.names)).toEqual([
      ["locus0", "locus2"],
      ["locus1", "locus3"],
    ]);
    while (workers.some((w) => w.work.length > 0)) {
      for (const worker of workers) if (worker.work.length > 0) worker.finish();
    }
    expect(log.accepted.sort()).toEqual(["locus0", "locus1", "locus2", "locus3", "locus4"]);
    expect(log.done).toBe(1);
    expect(p.busy).toBe(false);
  });

  it("hands out the last urgent slice of a job before what comes behind it", () => {
    const p = pool(1);
    const { job: locus } = job("locus", 4);
    let taken = 0;
    // Coarse slices first, which others wait for; then fine ones.
    p.submit({
      ...locus,
      priority: () => (taken < 2 ? 3 : 1),
      next: () => {
        taken++;
        return locus.next();
      },
    });
    const strip = job("strip", 1, 2);
    p.submit(strip.job);
    const [worker] = workers;
    const order: string[] = [];
    while (worker?.work[0]) {
      order.push((worker.work[0].args as { n: string }).n);
      worker.finish();
    }
    expect(order).toEqual(["locus0", "locus1", "strip0", "locus2", "locus3"]);
  });

  it("hears only the latest job of a channel", () => {
    const p = pool(1);
    const old = job("locus", 10);
    const now = job("locus", 1);
    p.submit(old.job);
    p.submit(now.job);
    const [worker] = workers;
    worker?.finish();
    worker?.finish();
    expect(old.log).toEqual({ accepted: [], failed: [], done: 0 });
    expect(now.log.accepted).toEqual(["locus0"]);
    expect(worker?.work).toEqual([]);
  });

  it("leaves other channels alone when one is replaced", () => {
    const p = pool(1);
    const verdict = job("verdict", 1);
    p.submit(job("locus", 3).job);
    p.submit(verdict.job);
    p.submit(job("locus", 1).job);
    for (let i = 0; i < 4; i++) workers[0]?.finish();
    expect(verdict.log.accepted).toEqual(["verdict0"]);
  });

  it("hands out nothing more after a cancel", () => {
    const p = pool(1);
    const { job: j, log } = job("locus", 10);
    p.submit(j);
    p.cancel("locus");
    workers[0]?.finish();
    expect(workers[0]?.work).toEqual([]);
    expect(log).toEqual({ accepted: [], failed: [], done: 0 });
    expect(p.busy).toBe(false);
  });

  it("serves the more urgent first", () => {
    const p = pool(1);
    const slow = job("strip", 3, 1);
    const urgent = job("verdict", 1, 9);
    p.submit(slow.job);
    p.submit(urgent.job);
    workers[0]?.finish();
    expect(workers[0]?.work[0]?.args).toMatchObject({ n: "verdict0" });
  });

  it("has nothing of another channel wait behind a slice", () => {
    const p = pool(2);
    p.submit(job("locus", 1, 9).job);
    p.submit(job("strip", 2, 1).job);
    expect(workers.map((w) => w.names)).toEqual([["locus0"], ["strip0", "strip1"]]);
  });

  it("gives what waits behind a slice to a worker that has nothing to do, and counts it once", () => {
    const p = pool(2);
    const { job: j, log } = job("locus", 4);
    p.submit(j);
    const [first, second] = workers;
    second?.finish();
    second?.finish();
    expect([first?.names, second?.names]).toEqual([["locus0", "locus2"], ["locus2"]]);
    // The first had begun it before it heard of that.
    for (const id of first?.work.map((one) => one.id) ?? [])
      first?.say({ type: "done", id, result: new Uint8Array([id]), milliseconds: 1 });
    expect([log.accepted.sort(), log.done]).toEqual([["locus0", "locus1", "locus2", "locus3"], 1]);
    expect(second?.stopped).toHaveLength(1);
    second?.finish();
    expect([log.accepted.length, log.done]).toEqual([4, 1]);
  });

  it("has a slice that was called back done later", () => {
    const p = pool(1);
    const slow = job("strip", 3, 1);
    p.submit(slow.job);
    p.submit(job("verdict", 1, 9).job);
    for (let i = 0; i < 4; i++) workers[0]?.finish();
    expect([slow.log.accepted.sort(), slow.log.done]).toEqual([["strip0", "strip1", "strip2"], 1]);
    expect(p.busy).toBe(false);
  });

  it("lets a slice stand that waits for nothing but what was called back", () => {
    const p = pool(2);
    const slow = job("strip", 4);
    p.submit(slow.job);
    const urgent = job("verdict", 1, 9);
    p.submit(urgent.job);
    // Both end what is under way, and have not answered yet that they will not begin what was behind it.
    for (const worker of workers) {
      const { id } = worker.work.shift() ?? { id: -1 };
      worker.say({ type: "done", id, result: new Uint8Array(), milliseconds: 1 });
    }
    expect(workers.flatMap((w) => w.names).filter((name) => name === "verdict0")).toHaveLength(1);
    for (let k = 0; k < 4; k++) for (const worker of workers) if (worker.work.length > 0) worker.finish();
    expect([urgent.log.accepted, slow.log.accepted.sort()]).toEqual([
      ["verdict0"],
      ["strip0", "strip1", "strip2", "strip3"],
    ]);
  });

  it("outlasts a storm of a thousand jobs, with little in its workers' queues", () => {
    const p = pool(2);
    let last = job("locus", 0);
    let seen = 0;
    let most = 0;
    for (let k = 0; k < 1000; k++) {
      last = job("locus", 6, 1 + (k % 3));
      p.submit(last.job);
      if (k % 5 === 0) p.submit(job("verdict", 1, 9).job);
      if (k % 7 === 0) p.cancel("verdict");
      if (k % 11 === 0) workers[k % 2]?.finish();
      if (k % 101 === 0) workers.find((w) => !w.terminated)?.die();
      for (const worker of workers.slice(seen)) worker.say({ type: "ready" });
      seen = workers.length;
      most = Math.max(most, ...workers.map((w) => (w.terminated ? 0 : w.work.length)));
    }
    const alive = workers.filter((w) => !w.terminated);
    while (alive.some((w) => w.work.length > 0)) for (const w of alive) if (w.work.length > 0) w.finish();
    expect(last.log.accepted.sort()).toEqual(Array.from({ length: 6 }, (_, k) => `locus${k}`));
    expect([last.log.done, last.log.failed, p.busy]).toEqual([1, [], false]);
    expect(most).toBeLessThanOrEqual(4);
  });

  it("replaces a dead worker and does its slice again", () => {
    const p = pool(1);
    const { job: j, log } = job("locus", 2);
    p.submit(j);
    workers[0]?.die();
    expect(workers[0]?.terminated).toBe(true);
    expect(workers).toHaveLength(2);
    workers[1]?.say({ type: "ready" });
    workers[1]?.finish();
    workers[1]?.finish();
    expect(log.accepted).toEqual(["locus0", "locus1"]);
    expect(log.done).toBe(1);
  });

  it("gives up a slice that kills every worker, and goes on", () => {
    const p = pool(1);
    const { job: j, log } = job("locus", 2);
    p.submit(j);
    for (let i = 0; i < 3; i++) {
      workers.at(-1)?.die();
      workers.at(-1)?.say({ type: "ready" });
    }
    expect(log.failed).toEqual(["worker-lost"]);
    workers.at(-1)?.finish();
    expect(log.accepted).toEqual(["locus1"]);
    expect(log.done).toBe(1);
  });

  it("replaces a worker whose instance has trapped", () => {
    const p = pool(1);
    const { job: j, log } = job("locus", 1);
    p.submit(j);
    const id = workers[0]?.work[0]?.id ?? -1;
    workers[0]?.say({ type: "failed", id, error: { code: "internal", message: "unreachable" }, fatal: true });
    workers[1]?.say({ type: "ready" });
    workers[1]?.finish();
    expect(log.accepted).toEqual(["locus0"]);
  });

  it("waits for a long task that breathes, and tells it when it is not wanted any more", () => {
    vi.useFakeTimers();
    const one = pool(1);
    const long = job("plan3", 1);
    one.submit(long.job);
    const [worker] = workers;
    const id = worker?.work[0]?.id ?? -1;
    for (let seconds = 0; seconds < 60; seconds += 15) {
      vi.advanceTimersByTime(15_000);
      worker?.say({ type: "progress", id, value: null });
    }
    expect([workers.length, worker?.terminated, worker?.stopped]).toEqual([1, false, []]);
    // The latest request wins.
    const next = job("plan3", 1);
    one.submit(next.job);
    expect(worker?.stopped).toEqual([id]);
    worker?.work.shift();
    worker?.say({ type: "failed", id, error: { code: "stopped", message: "" }, fatal: false });
    worker?.finish();
    expect([long.log.failed, next.log.accepted]).toEqual([[], ["plan30"]]);
    vi.useRealTimers();
  });

  it("takes a silent worker for dead", () => {
    vi.useFakeTimers();
    const p = pool(1);
    p.submit(job("locus", 1).job);
    vi.advanceTimersByTime(60_000);
    expect(workers[0]?.terminated).toBe(true);
    vi.useRealTimers();
    p.close();
  });

  it("says so when no worker can be had", () => {
    const onUnavailable = vi.fn();
    new Pool({
      count: 2,
      modules,
      onUnavailable,
      spawn: () => {
        throw new Error("not allowed");
      },
    });
    expect(onUnavailable).toHaveBeenCalledTimes(1);
  });

  it("says so when workers die before they are ready", () => {
    const onUnavailable = vi.fn();
    const spawn = () => {
      const worker = new FakeWorker();
      workers.push(worker);
      return worker;
    };
    new Pool({ count: 2, modules, onUnavailable, spawn });
    while (workers.some((w) => !w.terminated)) workers.find((w) => !w.terminated)?.die();
    expect(onUnavailable).toHaveBeenCalledTimes(1);
    expect(workers.length).toBeLessThan(6);
  });
});

describe("Coalesce", () => {
  it("lets the one under way finish and then takes only the last", () => {
    const p = pool(1);
    const queue = new Coalesce((j) => p.submit(j));
    const jobs = [job("verdict", 1), job("verdict", 1), job("verdict", 1)];
    for (const { job: j } of jobs) queue.request(() => j);
    for (let i = 0; i < 3; i++) if (workers[0]?.work.length) workers[0].finish();
    expect(jobs.map(({ log }) => log.done)).toEqual([1, 0, 1]);
  });
});

describe("a pool without workers", () => {
  const onPage = (plan: () => unknown) =>
    new Pool({ count: 1, modules, spawn: () => new OnPage(performerOf({ plan }, async () => ({}))) });
  const settled = async (made: Pool) => {
    while (made.busy) await new Promise((resolve) => setTimeout(resolve));
  };

  it("does the same on one thread", async () => {
    const made = onPage(() => null);
    const { job: j, log } = job("locus", 3);
    made.submit(j);
    await settled(made);
    expect(log.accepted).toHaveLength(3);
    expect(log.done).toBe(1);
  });

  it("hears only the latest job of a channel", async () => {
    const made = onPage(() => null);
    const old = job("locus", 3);
    const now = job("locus", 2);
    made.submit(old.job);
    made.submit(now.job);
    await settled(made);
    expect(old.log.accepted).toEqual([]);
    expect(now.log.accepted).toHaveLength(2);
  });

  it("tells a failure to the job and goes on", async () => {
    const made = onPage(() => {
      throw { code: "no-attractor", message: "None." };
    });
    const { job: j, log } = job("locus", 2);
    made.submit(j);
    await settled(made);
    expect(log.failed).toEqual(["no-attractor", "no-attractor"]);
  });

  it("says so, and why, when it cannot start", async () => {
    const why = await new Promise((resolve) => {
      const performer = performerOf({}, () => Promise.reject({ code: "offline", message: "Offline." }));
      new Pool({ count: 1, modules, spawn: () => new OnPage(performer), onUnavailable: resolve });
    });
    expect(why).toEqual({ code: "offline", message: "Offline." });
  });
});
