import { signal } from "@preact/signals";
import { expect, it, vi } from "vitest";
import type { Uv } from "#geometry/path";

vi.mock("#wasm/core", () => ({ frond: {} }));
vi.mock("#compute/results", () => ({
  verdict: signal<unknown>(null),
  along: signal(null),
  locus: signal(null),
  pathBreaks: signal([]),
}));

const results = await import("#compute/results");
const { toneAt } = await import("./waypoints");
const verdict = results.verdict as unknown as { value: unknown };

it("tells a point of the map what is said of the shape there, and no other", () => {
  const at: Uv = [0.25, 0.5];
  const say = (word: string, stale = false) => {
    const connectedness = { verdict: word, gap: { lower: 0, upper: 0.1 }, diameter: 1 };
    verdict.value = { connectedness, epsilon: 1 / 600, uv: at, stale };
  };
  expect(toneAt(at)).toBeNull();
  const tones = ["connected", "touching", "disconnected", "undecided"].map((word) => {
    say(word);
    return toneAt(at);
  });
  expect(tones).toEqual(["whole", "close", "broken", "unknown"]);
  // A proof holds for one parameter: not for one as near as can be, nor for where the picture has gone since.
  expect(toneAt([0.25, 0.5])).toBeNull();
  say("connected", true);
  expect(toneAt(at)).toBeNull();
});
