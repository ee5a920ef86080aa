import { expect, it } from "vitest";
import type { LocusResult } from "#compute/results";
import { STATE } from "#geometry/states";
import { blankChart, chartJob } from "./morph-locus";

const ENDS = { from: [], to: [] };

it("asks for every row once and puts it where it belongs", () => {
  let last: LocusResult | null = null;
  const job = chartJob("figure:0", { ends: ENDS, options: {}, size: 10 }, (field) => {
    last = field;
  });
  const rows: number[] = [];
  for (let task = job.next(); task; task = job.next()) {
    const count = (task.r1 - task.r0) * 10;
    for (let r = task.r0; r < task.r1; r++) rows.push(r);
    const state = new Uint8Array(count).fill(task.r0 === 0 ? STATE.touching : STATE.disconnected);
    job.accept(task, { state, gap: new Float32Array(count).fill(task.r0) }, 1);
  }
  expect(rows).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
  const field = last as LocusResult | null;
  expect(field?.progress).toBe(1);
  expect(field?.state[0]).toBe(STATE.touching);
  expect(field?.state[99]).toBe(STATE.disconnected);
  expect(field?.gap[99]).toBe(8);
});

it("counts rows that failed as done, and leaves them blank", () => {
  let progress = 0;
  const job = chartJob("figure:0", { ends: ENDS, options: {}, size: 4 }, (field) => {
    progress = field.progress;
    expect(field.state).toEqual(blankChart(4).state);
  });
  const task = job.next();
  if (task) job.fail(task, { code: "internal", message: "no" });
  expect(progress).toBe(1);
});
