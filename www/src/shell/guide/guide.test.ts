import { describe, expect, it } from "vitest";
import { LESSONS } from "#figures/lessons/course";
import { WORDS } from "#ui/terms/words";
import type { Scene } from "#wasm/api";
import { seenIn } from "./seen";
import { type Doing, STEPS } from "./steps";

const doing = (change: Partial<Omit<Doing, "scene">> & { t?: number; kind?: string } = {}): Doing => ({
  scene: { t: change.t ?? 0, path: { kind: change.kind ?? "drawn", points: [] } } as unknown as Scene,
  playing: change.playing ?? false,
  evidence: change.evidence ?? false,
});

describe("the round", () => {
  it("knows when each step is done, and not before", () => {
    const [play, straight, map, round, why] = STEPS;
    const before = doing();
    expect(STEPS.map((step) => step.done?.(before, before) ?? null)).toEqual([
      false,
      false,
      null,
      false,
      false,
    ]);
    expect(play?.done?.(doing({ playing: true }), before)).toBe(true);
    expect(play?.done?.(doing({ t: 0.2 }), before)).toBe(true);
    expect(straight?.done?.(doing({ kind: "straight" }), before)).toBe(true);
    expect(map?.done).toBeUndefined();
    expect(round?.done?.(doing({ kind: "straight" }), before)).toBe(false);
    expect(round?.done?.(doing({ kind: "auto" }), before)).toBe(true);
    expect(why?.done?.(doing({ evidence: true }), before)).toBe(true);
  });
});

it("reads how far somebody was, and trusts nothing else", () => {
  expect(seenIn(null, 5)).toBeNull();
  expect(seenIn("3", 5)).toBe(3);
  for (const text of ["5", "99", "seen", "", "-1", "1e3", "<b>"]) expect(seenIn(text, 5)).toBe("seen");
});

it("explains each word once, in a sentence, and leads to a lesson that there is", () => {
  expect(new Set(WORDS.map(({ word }) => word)).size).toBe(WORDS.length);
  for (const { word, means, lesson } of WORDS) {
    expect(means, word).toMatch(/[.]$/);
    if (lesson)
      expect(
        LESSONS.map(({ id }) => id),
        word,
      ).toContain(lesson);
  }
});
