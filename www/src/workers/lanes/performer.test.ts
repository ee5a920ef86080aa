import { describe, expect, it } from "vitest";
import { performerOf } from "./performer";
import type { Answer, Context } from "./task";

const slow = async (context: Context, args: { turns: number }) => {
  for (let i = 0; i < args.turns; i++) await context.breathe();
  return "slow";
};
const tell = (context: Context & { word: string }) => context.word;
const performer = performerOf({ slow, tell }, async () => ({ word: "at hand" }));

/** Everything that is answered, once `count` tasks have ended. */
function listen(count: number) {
  const answers: Answer[] = [];
  let ended: () => void = () => {};
  const all = new Promise<void>((resolve) => (ended = resolve));
  const perform = performer((answer) => {
    answers.push(answer);
    if (answers.filter((one) => one.type !== "progress").length === count) ended();
  });
  return { answers, all, perform };
}

const run = (id: number, turns: number) => ({ type: "run", id, name: "slow", args: { turns } }) as const;
const start = { type: "start", module: {} as WebAssembly.Module } as const;

describe("a performer", () => {
  it("does one task after the other", async () => {
    const { answers, all, perform } = listen(2);
    perform(start);
    perform(run(1, 3));
    perform(run(2, 0));
    await all;
    expect(answers.map((answer) => [answer.type, answer.id])).toEqual([
      ["done", 1],
      ["done", 2],
    ]);
  });

  it("stops the one under way when it breathes, and one that waits at once", async () => {
    const { answers, all, perform } = listen(3);
    perform(start);
    perform(run(1, 1e9));
    perform(run(2, 0));
    perform(run(3, 0));
    await new Promise((resolve) => setTimeout(resolve, 5));
    perform({ type: "stop", id: 2 });
    expect(answers).toMatchObject([{ type: "failed", id: 2, error: { code: "stopped" } }]);
    perform({ type: "stop", id: 1 });
    await all;
    expect(answers.slice(1)).toMatchObject([
      { type: "failed", id: 1, error: { code: "stopped" } },
      { type: "done", id: 3 },
    ]);
  });

  it("gives tasks what its start has readied", async () => {
    const { answers, all, perform } = listen(1);
    perform(start);
    perform({ type: "run", id: 1, name: "tell", args: {} });
    await all;
    expect(answers).toEqual([{ type: "done", id: 1, result: "at hand" }]);
  });

  it("says so where nothing was started", async () => {
    const { answers, all, perform } = listen(1);
    perform(run(1, 0));
    await all;
    expect(answers).toMatchObject([{ type: "failed", error: { code: "not-started" } }]);
  });
});
