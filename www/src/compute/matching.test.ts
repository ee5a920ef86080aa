import { describe, expect, it } from "vitest";
import type { RatedCandidate } from "#wasm/api";
import { byMerit } from "./matching";

const rated = (plan: Partial<RatedCandidate["plan"]>, cost = 1): RatedCandidate => ({
  correspondence: [],
  turns: [],
  cost,
  plan: { points: [], gap: 0, holds: true, clearance: 0.1, ...plan },
  share: 0.5,
  locus: { width: 0, height: 0, state: new Uint8Array(), gap: new Float32Array() },
});

describe("byMerit", () => {
  it("puts what holds first, then the narrowest gap, the most room, the plainest", () => {
    const plain = rated({}, 0.5);
    const roomy = rated({ clearance: 0.3 }, 2);
    const narrow = rated({ holds: false, gap: 0.01 });
    const wide = rated({ holds: false, gap: 0.2, clearance: 9 });
    const none = rated({ holds: false, gap: Number.POSITIVE_INFINITY });
    const order = [none, wide, rated({}, 3), narrow, plain, roomy].sort(byMerit);
    expect(order.map(({ plan, cost }) => [plan.gap, cost])).toEqual([
      [0, 2],
      [0, 0.5],
      [0, 3],
      [0.01, 1],
      [0.2, 1],
      [Number.POSITIVE_INFINITY, 1],
    ]);
  });

  it("takes a plan of which less is known", () => {
    const bare = rated({});
    Reflect.deleteProperty(bare.plan, "clearance");
    expect([bare, rated({})].sort(byMerit)[1]).toBe(bare);
  });
});
