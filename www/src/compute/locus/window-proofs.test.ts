import { describe, expect, it, vi } from "vitest";
import { STATE } from "#geometry/states";
import type { LocusView } from "#wasm/api";
import type { Result, Task } from "#workers/pool/protocol";
import { Pyramid } from "./pyramid";
import { windowOf } from "./window";
import { WindowWork } from "./window-job";
import { WindowProofs } from "./window-proofs";

const at: LocusView = { family: "morph", sides: 2, x: 0.5, y: 0.5, zoom: 4, w: 0 };

/** A window all of whose samples touch. */
function known(view: LocusView): WindowWork {
  const pyramid = new Pyramid({ family: "morph", inputs: { from: [], to: [], options: {} }, w: 0 });
  const work = new WindowWork(pyramid, { painted() {}, coarse() {}, failed() {} }, true);
  work.want(view);
  const job = work.job();
  for (let task = job.next(); task; task = job.next()) {
    const [width, height] = task.kind === "patch" ? [task.x1 - task.x0, task.y1 - task.y0] : [0, 0];
    const state = new Uint8Array(width * height).fill(STATE.touching);
    job.accept(task, { state, gap: new Float32Array(state.length) }, 1);
  }
  return work;
}

/** Proves every second sample. */
const half = ({ state }: Task<"prove">): Result<"prove"> =>
  state.map((s, k) => (k % 2 === 0 ? STATE.connected : s));

const count = (work: WindowWork, view: LocusView, state: number) =>
  work.pyramid.read(windowOf(view), view.zoom).state.filter((s) => s === state).length;

describe("WindowProofs", () => {
  it.each([4, 1e6])(
    "asks once for all that touches in the window, and keeps what is proved (zoom %d)",
    (zoom) => {
      const view = { ...at, zoom };
      const work = known(view);
      const painted = vi.fn();
      const proofs = new WindowProofs(work, view, 1, painted);
      const job = proofs.job();
      const keys = new Set<number>();
      let samples = 0;
      for (let task = job.next(); task; task = job.next()) {
        keys.add(task.key);
        const { options } = task.of;
        expect(task.x1).toBeLessThanOrEqual(options.width ?? 0);
        expect(task.state).toHaveLength((task.x1 - task.x0) * (task.y1 - task.y0));
        expect(task.state.every((s) => s === STATE.touching)).toBe(true);
        samples += task.state.length;
        job.accept(task, half(task), 1);
      }
      const shown = work.pyramid.read(windowOf(view), zoom).state.length;
      expect(samples).toBeGreaterThanOrEqual(shown);
      expect(count(work, view, STATE.connected)).toBeGreaterThan(0.4 * shown);
      expect(count(work, view, STATE.touching)).toBeGreaterThan(0.4 * shown);
      expect(proofs.done).toBe(true);
      // A grid for each tile only where there is none over all.
      expect(keys.size).toBe(zoom === 4 ? 1 : work.pyramid.missing(windowOf(view), zoom).count);
      // What was tried in vain is not asked for again.
      expect(new WindowProofs(work, view, 1, painted).job().next()).toBeNull();
    },
  );

  it("ends after a minute of work, and leaves what a slice that fails was about to prove", () => {
    const work = known(at);
    const proofs = new WindowProofs(work, at, 1, () => {});
    const job = proofs.job();
    const first = job.next();
    if (first) job.fail(first, { code: "worker-lost", message: "" });
    let slices = 0;
    for (let task = job.next(); task; task = job.next(), slices++) job.accept(task, half(task), 4000);
    expect(slices).toBe(16);
    expect(proofs.done).toBe(true);
    expect(new WindowProofs(work, at, 1, () => {}).job().next()).not.toBeNull();
  });
});
