import { beforeEach, describe, expect, it, vi } from "vitest";
import { Pool } from "./pool";
import type { Drawing, FromWorker, Job, Question, ToWorker } from "./protocol";
import { work } from "./work";

vi.mock("./element.worker?program", () => ({ default: "" }));
vi.mock("./work", () => ({ work: vi.fn() }));

/** A worker that answers when it is told to. */
class Hand {
  static all: Hand[] = [];
  static refused = false;
  onmessage: ((event: { data: FromWorker }) => void) | null = null;
  onerror: (() => void) | null = null;
  readonly jobs: Job[] = [];

  constructor() {
    if (Hand.refused) throw new TypeError("No workers here.");
    Hand.all.push(this);
  }

  postMessage(message: ToWorker) {
    if ("job" in message) this.jobs.push(message.job);
  }

  answer(answer: FromWorker = { result: null }) {
    this.onmessage?.({ data: answer });
  }

  terminate() {}
}

const drawing = (fragment: string) => ({ fragment }) as Drawing;
const question = (name: number, to = true) =>
  ({ maps: [[name]], ...(to ? { to: [[name]] } : {}) }) as Question;
const named = (jobs: Job[]) =>
  jobs.map((job) => (job.kind === "draw" ? job.drawing.fragment : job.question.maps[0]?.[0]));
const always = () => true;

let pool: Pool;
const made = () => {
  pool = new Pool({} as WebAssembly.Module);
  return Hand.all;
};

beforeEach(() => {
  Hand.all = [];
  Hand.refused = false;
  vi.stubGlobal("Worker", Hand);
});

describe("the workers of the elements of a page", () => {
  it("draw first pictures before all else, and one never does anything but draw", () => {
    const [draws, both] = made();
    const seen = () => [named(draws?.jobs ?? []), named(both?.jobs ?? [])];
    const asked = [1, 2].map((name) => pool.ask(question(name), always));
    expect(seen()).toEqual([[], [1]]);
    for (const name of ["a", "b"]) void pool.draw(drawing(name), false);
    void pool.draw(drawing("c"), true);
    void pool.draw(drawing("d"), true);
    both?.answer({ result: "found" });
    draws?.answer();
    expect(seen()).toEqual([
      ["a", "d"],
      [1, "c"],
    ]);
    // What moves leaves room for what is asked.
    draws?.answer();
    both?.answer();
    expect(seen()).toEqual([
      ["a", "d", "b"],
      [1, "c", 2],
    ]);
    void pool.draw(drawing("e"), false);
    both?.answer();
    expect(seen()[1]).toEqual([1, "c", 2, "e"]);
    return expect(asked[0]).resolves.toBe("found");
  });

  it("say whether a shape holds together before they look for paths, and leave what nobody waits for", async () => {
    const [, both] = made();
    let waits = true;
    const failed = pool.ask(question(1), always);
    const left = pool.ask(question(2), () => waits);
    void pool.ask(question(3), always);
    void pool.ask(question(4, false), always);
    waits = false;
    both?.answer({ failure: { code: "bad", message: "Bad." } });
    both?.answer();
    expect(named(both?.jobs ?? [])).toEqual([1, 4, 3]);
    await expect(failed).rejects.toMatchObject({ name: "FrondError", code: "bad" });
    await expect(left).rejects.toMatchObject({ name: "FrondError", code: "cancelled" });
  });

  it("are done without: the page draws at once, and pauses in what takes long", async () => {
    Hand.refused = true;
    made();
    const order: string[] = [];
    vi.mocked(work).mockImplementation(async (job, breathe) => {
      if (job.kind === "draw") order.push("draw");
      for (let i = 0; job.kind === "ask" && i < 3; i++) {
        await breathe?.();
        order.push("slice");
      }
      return null as never;
    });
    const found = pool.ask(question(1), always);
    await pool.draw(drawing("a"), true);
    expect(order).toEqual(["draw"]);
    await found;
    expect(order).toEqual(["draw", "slice", "slice", "slice"]);
    // Whoever goes away stops it.
    let waits = true;
    const left = pool.ask(question(2), () => waits);
    waits = false;
    await expect(left).rejects.toMatchObject({ code: "cancelled" });
  });

  it("hand on what a worker had to do that is gone", () => {
    const [draws, both] = made();
    void pool.draw(drawing("a"), true);
    draws?.onerror?.();
    expect(named(both?.jobs ?? [])).toEqual(["a"]);
    // Alone it answers as well.
    void pool.ask(question(1), always);
    both?.answer();
    expect(named(both?.jobs ?? [])).toEqual(["a", 1]);
  });
});
