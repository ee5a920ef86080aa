import { describe, expect, it } from "vitest";
import type { PathPlan } from "#wasm/api";
import { isBetterThan, type Offer } from "./ways";

const plan = (gap: number): PathPlan => ({ points: [], gap, holds: gap === 0, clearance: 0 });
const offer = (gap: number): Offer => ({ way: null, plan: plan(gap) });

describe("another way", () => {
  it("is better where it holds, or breaks clearly less than all before it", () => {
    expect(isBetterThan(plan(0), 0.1, null)).toBe(true);
    expect(isBetterThan(plan(0.05), 0.1, null)).toBe(true);
    expect(isBetterThan(plan(0.099), 0.1, null)).toBe(false);
    expect(isBetterThan(plan(0.05), 0.1, offer(0.04))).toBe(false);
    expect(isBetterThan(plan(0.03), 0.1, offer(0.04))).toBe(true);
    expect(isBetterThan(plan(Number.POSITIVE_INFINITY), Number.POSITIVE_INFINITY, null)).toBe(false);
  });

  it("is not replaced once it holds", () => {
    expect(isBetterThan(plan(0), 0.1, offer(0.04))).toBe(true);
    expect(isBetterThan(plan(0), 0.1, offer(0))).toBe(false);
  });
});
