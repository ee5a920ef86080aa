import { expect, test } from "vitest";
import { InTurn, isStopped, Latest } from "./latest";

test("the one before is called off", () => {
  const latest = new Latest();
  const first = latest.begin();
  const second = latest.begin();
  expect([first.aborted, second.aborted]).toEqual([true, false]);
  latest.stop();
  expect(second.aborted).toBe(true);
});

test("of those that wait only the last is done, and what is under way ends first", async () => {
  const turn = new InTurn();
  const done: number[] = [];
  let open: () => void = () => {};
  turn.ask(async () => {
    await new Promise<void>((resolve) => {
      open = resolve;
    });
    done.push(1);
  });
  for (const i of [2, 3, 4]) turn.ask(async () => void done.push(i));
  expect(done).toEqual([]);
  open();
  await new Promise((resolve) => setTimeout(resolve));
  expect(done).toEqual([1, 4]);
});

test("what was stopped is told from what went wrong", () => {
  expect(isStopped({ code: "stopped", message: "" })).toBe(true);
  expect([isStopped(null), isStopped("stopped"), isStopped({ code: "worker-lost" })]).not.toContain(true);
});
