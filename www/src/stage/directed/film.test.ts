import { afterEach, expect, test, vi } from "vitest";
import { publish, standInFilm } from "#compute/results";
import type { Told } from "#format/verdict";
import type { Way } from "#workers/directed/moment";
import { judge } from "./film";

const directedTask = vi.hoisted(() => vi.fn());
vi.mock("#workers/directed/client", () => ({ directedTask }));

const way: Way = { from: { states: [] }, to: { states: [] }, mode: "linear" };
const TIMES = [0, 0.5, 1];
const told = (verdict: Told["verdict"]): Told => ({ verdict, gap: { lower: 0, upper: 0 }, diameter: 1 });
const begin = () => {
  publish.standInFilm.value = TIMES.map((t) => ({ t, verdict: null, bitmap: null, stale: false }));
};
const marks = () => standInFilm.value.map(({ verdict }) => verdict?.verdict ?? null);
type Asked = { moment: { t: number }; epsilon: number };
/** What is known of a moment, by how finely one looks. */
const answers = (known: (t: number, fine: boolean) => Told["verdict"] | "never") =>
  directedTask.mockImplementation((_task: string, { moment, epsilon }: Asked) => {
    const verdict = known(moment.t, epsilon < 1 / 300);
    return verdict === "never" ? new Promise(() => {}) : Promise.resolve({ states: [told(verdict)] });
  });

afterEach(() => directedTask.mockReset());

test("stills with a wide gap are marked before anything that takes long is asked", async () => {
  begin();
  answers((t, fine) => (fine ? "never" : t === 0.5 ? "disconnected" : "touching"));
  void judge(way, new AbortController().signal);
  await vi.waitFor(() => expect(directedTask).toHaveBeenCalledTimes(TIMES.length + 1));
  // What only seems whole from afar is not said to be.
  expect(marks()).toEqual([null, "disconnected", null]);
});

test("then each is known as well as it can be, and no gap is lost", async () => {
  begin();
  answers((t, fine) => (t === 0.5 ? (fine ? "undecided" : "disconnected") : fine ? "touching" : "undecided"));
  await judge(way, new AbortController().signal);
  expect(marks()).toEqual(["touching", "disconnected", "touching"]);
  const asked = directedTask.mock.calls.map(([, { moment, epsilon }]) => [moment.t, epsilon < 1 / 300]);
  expect(asked.slice(3)).toEqual([
    [0, true],
    [1, true],
    [0.5, true],
  ]);
});

test("of another way nothing is said any more", async () => {
  begin();
  const end = new AbortController();
  answers(() => "disconnected");
  const done = judge(way, end.signal);
  end.abort();
  await done;
  expect(marks()).toEqual([null, null, null]);
});
