import { describe, expect, it } from "vitest";
import { adviceOf, foretell, type MeshPlan, measuredAt, meshProblem, meshWords, wallOf } from "./plan";

const PLAN: MeshPlan = { format: "stl", fineness: 192, size: 100, wall: 2 };
const facts = (triangles: number, found: number) => ({
  triangles,
  found,
  parts: 1,
  size: [100, 50, 9.5] as [number, number, number],
  volume: 1,
  wall: 2,
});
const measured = [
  { fineness: 48, facts: facts(10_000, 1000) },
  { fineness: 96, facts: facts(40_000, 8000) },
];

describe("what a mesh will be", () => {
  it("is measured where that is quick, and else told from two that are coarser", () => {
    expect(measuredAt(64)).toEqual([64]);
    expect(measuredAt(128)).toEqual([48, 96]);
    expect(foretell(96, measured.slice(1))).toMatchObject({ triangles: 40_000, exact: true });
    const told = foretell(192, measured);
    expect(told?.exact).toBe(false);
    expect(told?.triangles).toBeCloseTo(160_000);
    expect(told?.found).toBeCloseTo(64_000);
    expect(foretell(192, [])).toBeNull();
  });

  it("is said in millimetres, triangles and bytes", () => {
    const told = foretell(192, measured);
    if (!told) throw new Error("nothing is told");
    expect(meshWords(told, 8e6)).toBe("100 × 50 × 9.5 mm · about 160 000 triangles · about 8 MB");
    expect(meshWords({ ...told, triangles: 3_140_000, exact: true }, 157e6)).toBe(
      "100 × 50 × 9.5 mm · 3.1 million triangles · 157 MB",
    );
  });

  it("is refused where it is too large, with what to choose instead", () => {
    const cube = { ...facts(100_000, 1), size: [100, 100, 100] as [number, number, number], exact: false };
    expect(meshProblem(PLAN, cube)).toBeNull();
    const most = Number(/(\d+) or less/.exec(meshProblem({ ...PLAN, fineness: 600 }, cube) ?? "")?.[1]);
    expect(most).toBeGreaterThan(280);
    expect(meshProblem({ ...PLAN, fineness: most }, cube)).toBeNull();
    expect(meshProblem(PLAN, { ...cube, triangles: 7.5e6 })).toMatch(/about 7\.5 million triangles.*lower/);
    expect(meshProblem(PLAN, null)).toBeNull();
  });

  it("says where walls are thicker than asked, and where parts fall apart", () => {
    const told = { ...facts(1, 1), exact: true };
    expect(adviceOf(PLAN, told)).toEqual([]);
    expect(wallOf({ ...PLAN, fineness: 100 })).toBe(3);
    expect(adviceOf({ ...PLAN, fineness: 100 }, { ...told, parts: 8 })).toEqual([
      "At this resolution the walls are 3 mm thick. A higher resolution makes thinner walls.",
      "The mesh is in 8 separate parts. Thicker walls may join them.",
    ]);
  });
});
