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
    if (answers.filter((one) => one.type !== "progress" && one.type !== "ready").length === count) ended();
  });
  return { answers, all, perform };
}

const run = (id: number, turns: number) => ({ type: "run", id, name: "slow", args: { turns } }) as const;
const start = { type: "start", module: {} as WebAssembly.Module } as const;

describe("a performer", () => {
  it("says when it is ready and what came of a task", async () => {
    const { answers, all, perform } = listen(1);
    perform(start);
    await Promise.resolve();
    perform(run(1, 3));
    await all;
    expect(answers).toMatchObject([{ type: "ready" }, { type: "done", id: 1, result: "slow" }]);
  });

  it("stops the one under way when it breathes, and does the next", async () => {
    const { answers, all, perform } = listen(1);
    perform(start);
    perform(run(1, 1e9));
    await new Promise((resolve) => setTimeout(resolve, 10));
    perform({ type: "stop", id: 1 });
    await all;
    expect(answers.slice(1)).toMatchObject([{ type: "failed", id: 1, error: { code: "stopped" } }]);
    // Word that comes too late, of a task that has ended.
    const next = new Promise((resolve) => setTimeout(resolve, 20));
    perform(run(2, 1));
    perform({ type: "stop", id: 1 });
    await next;
    expect(answers.at(-1)).toMatchObject({ type: "done", id: 2 });
  });

  it("does one after the other, and does not begin what is called off before its turn", async () => {
    for (const atOnce of [false, true]) {
      const order: string[] = [];
      const answers: Answer[] = [];
      const table = {
        note: async (_: Context, { word }: { word: string }) => {
          order.push(`${word} begins`);
          await new Promise((resolve) => setTimeout(resolve, 2));
          order.push(`${word} ends`);
        },
      };
      const made = performerOf(table, async () => ({}), atOnce);
      await new Promise<void>((resolve) => {
        const perform = made((answer) => {
          answers.push(answer);
          if (answers.length === 3) resolve();
        });
        for (const [id, word] of ["a", "b", "c"].entries())
          perform({ type: "run", id, name: "note", args: { word } });
        perform({ type: "stop", id: 1 });
      });
      expect(order).toEqual(["a begins", "a ends", "c begins", "c ends"]);
      expect(answers).toMatchObject([
        { type: "failed", id: 1, error: { code: "stopped" } },
        { type: "done", id: 0 },
        { type: "done", id: 2 },
      ]);
    }
  });

  it("gives tasks what its start has readied", async () => {
    const { answers, all, perform } = listen(1);
    perform(start);
    perform({ type: "run", id: 1, name: "tell", args: {} });
    await all;
    expect(answers.at(-1)).toMatchObject({ type: "done", id: 1, result: "at hand" });
  });

  it("says so where it cannot start", async () => {
    const answers: Answer[] = [];
    const unable = performerOf({}, () => Promise.reject({ code: "old", message: "Too old." }));
    unable((answer) => answers.push(answer))(start);
    await new Promise((resolve) => setTimeout(resolve));
    expect(answers).toEqual([{ type: "unable", error: { code: "old", message: "Too old." } }]);
  });
});
