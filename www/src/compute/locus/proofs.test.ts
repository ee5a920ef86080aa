import { describe, expect, it, vi } from "vitest";
import { STATE } from "#geometry/states";
import type { Result, Task } from "#workers/pool/protocol";
import { LocusWork, SIZE } from "./job";
import { LocusProofs } from "./proofs";

/** A whole locus whose left third touches, and the rest of which is in pieces. */
function whole(): LocusWork {
  const watch = { painted: vi.fn(), stage: vi.fn(), failed: vi.fn() };
  const means = { patches: true, priorities: (): [number, number] => [50, 15] };
  const work = new LocusWork({ from: [], to: [], options: {} }, watch, () => 1e9, means);
  const state = Uint8Array.from({ length: SIZE * SIZE }, (_, k) =>
    k % SIZE < SIZE / 3 ? STATE.touching : STATE.disconnected,
  );
  work.acceptWhole({ state, gap: new Float32Array(SIZE * SIZE).fill(0.1) });
  return work;
}

/** Proves every second sample that touches. */
const half = ({ state }: Task<"prove">): Result<"prove"> =>
  state.map((s, k) => (s === STATE.touching && k % 2 === 0 ? STATE.connected : s));

describe("LocusProofs", () => {
  it("asks once for each sample that touches, and takes what is proved", () => {
    const work = whole();
    const painted = vi.fn();
    const proofs = new LocusProofs(work, painted);
    const job = proofs.job();
    let touching = 0;
    let slices = 0;
    for (let task = job.next(); task; task = job.next()) {
      expect(task.of).toEqual(work.whole());
      expect(task.state).toHaveLength((task.x1 - task.x0) * (task.y1 - task.y0));
      touching += task.state.filter((s) => s === STATE.touching).length;
      slices++;
      expect(proofs.done).toBe(false);
      job.accept(task, half(task), 1);
    }
    expect(proofs.done).toBe(true);
    expect(painted).toHaveBeenCalledTimes(slices);
    const count = (state: number) => work.filled.state.filter((s) => s === state).length;
    expect(touching).toBe(Math.ceil(SIZE / 3) * SIZE);
    expect(count(STATE.connected) + count(STATE.touching)).toBe(touching);
    expect(count(STATE.connected)).toBeGreaterThan(touching / 3);
    expect(work.raw.state).toEqual(work.filled.state);
  });

  it("ends after half a minute of work, and keeps what it has", () => {
    const work = whole();
    const proofs = new LocusProofs(work, () => {});
    const job = proofs.job();
    let slices = 0;
    for (let task = job.next(); task; task = job.next(), slices++) job.accept(task, half(task), 4000);
    expect(slices).toBe(8);
    expect(proofs.done).toBe(true);
    expect(work.raw.state.includes(STATE.connected)).toBe(true);
    expect(work.raw.state.includes(STATE.touching)).toBe(true);
  });

  it("leaves what is in pieces as it is, whatever it is told, and goes on where a slice fails", () => {
    const work = whole();
    const proofs = new LocusProofs(work, () => {});
    const job = proofs.job();
    const all = (task: Task<"prove">) => task.state.map(() => STATE.connected);
    for (let task = job.next(), n = 0; task; task = job.next(), n++) {
      if (n === 0) job.fail(task, { code: "worker", message: "it died" } as Parameters<typeof job.fail>[1]);
      else job.accept(task, all(task), 1);
    }
    expect(proofs.done).toBe(true);
    const at = (x: number, y: number) => work.raw.state[y * SIZE + x];
    expect(at(Math.ceil(SIZE / 3) + 1, 0)).toBe(STATE.disconnected);
    expect(at(0, 0)).toBe(STATE.connected);
    expect(work.raw.state.includes(STATE.touching)).toBe(true);
  });
});
