import { describe, expect, it } from "vitest";
import { STATE } from "#geometry/states";
import { causeWords, chosen, counted, isOf } from "./Causes";

const bounds = { u0: -1, v0: -1, u1: 2, v1: 2 };

describe("samples that only look whole", () => {
  it("are all looked at where they are few", () => {
    const state = [STATE.connected, STATE.touching, STATE.disconnected, STATE.touching];
    expect(chosen({ width: 2, height: 2, state, bounds })).toEqual([
      [2, -1],
      [2, 2],
    ]);
    expect(chosen({ width: 2, height: 2, state: [0, 0, 2, 2], bounds })).toEqual([]);
  });

  it("are chosen evenly where they are many", () => {
    const field = { width: 100, height: 100, state: new Uint8Array(10_000).fill(STATE.touching), bounds };
    const points = chosen(field);
    expect(points).toHaveLength(48);
    expect(new Set(points.map(String)).size).toBe(48);
    const rows = points.map(([, v]) => v);
    expect(Math.min(...rows)).toBeLessThan(-0.9);
    expect(Math.max(...rows)).toBeGreaterThan(1.9);
  });
});

describe("causes", () => {
  it("come the most common first", () => {
    expect(counted(["near", "apart", "near"])).toEqual([
      ["near", 2],
      ["apart", 1],
    ]);
  });

  it("say proved only of what a search proves", () => {
    const all = (["apart", "search", "rounding", "near", "open"] as const).map((cause) =>
      causeWords(cause, 1 / 600),
    );
    expect(all.filter((words) => words.includes("proves it"))).toEqual([causeWords("search", 1 / 600)]);
    expect(causeWords("near", 1 / 600)).toContain("1/600 000");
  });
});

it("says of a map nothing that was found of another", () => {
  const [inputs, other] = [{}, {}];
  const found = { causes: [], of: 3, inputs, where: "all" };
  expect(isOf(found, inputs, "all")).toBe(found);
  expect(isOf(found, other, "all")).toBeNull();
  expect(isOf(found, inputs, "nearer")).toBeNull();
  expect(isOf(null, inputs, "all")).toBeNull();
});
