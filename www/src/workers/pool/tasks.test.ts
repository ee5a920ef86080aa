import { describe, expect, it } from "vitest";
import type { Connectedness, MapRow } from "#wasm/api";
import type { Frond } from "#wasm/core";
import type { Proof } from "#wasm/proof";
import type { Task } from "./protocol";
import { tasks } from "./tasks";

const maps: MapRow[] = [
  [0.5, 0, 0, 0.5, 0, 0],
  [0.5, 0, 0, 0.5, 0.5, 0],
];

/** A program that finds a gap of 0.001 only where it looks closer than that, and whose samples of the map see it. */
function program(sample: { state: number; gap: number; proved?: number }) {
  const asked: number[] = [];
  const answer = (verdict: Connectedness["verdict"], upper: number) => ({
    verdict,
    gap: { lower: 0, upper },
    diameter: 1,
    components: [0, 1],
  });
  const frond = {
    connectedness: (_: unknown, { epsilon }: { epsilon: number }) => {
      asked.push(epsilon);
      return epsilon < 1e-3 ? answer("disconnected", 1e-3) : answer("touching", 1e-3);
    },
    LocusTiles: class {
      patch = () => ({ state: Uint8Array.of(sample.state), gap: Float32Array.of(sample.gap) });
      prove = () => Uint8Array.of(sample.proved ?? sample.state);
      free() {}
    },
    interpolate: () => ({ maps }),
  } as unknown as Frond & Proof;
  const context = { frond, keep: new Map(), breathe: async () => {}, progress: () => {}, transfer: () => {} };
  const run = <K extends "verdict" | "along" | "causes">(task: Task<K>) =>
    tasks[task.kind as K](context, task);
  return { asked, run };
}

describe("the answer about one shape", () => {
  it("looks closer where the map has seen a gap and the search has not", async () => {
    const { run, asked } = program({ state: 2, gap: 8e-4 });
    const result = await run({ kind: "verdict", maps, epsilon: 1 / 600 });
    expect(result).toMatchObject({ verdict: "disconnected" });
    expect(asked).toEqual([1 / 600, Math.fround(8e-4) / 4]);
  });

  it("is left as it is where the map has seen none", async () => {
    const { run, asked } = program({ state: 1, gap: 0 });
    const result = await run({ kind: "verdict", maps, epsilon: 1 / 600 });
    expect(result).toMatchObject({ verdict: "touching" });
    expect(asked).toHaveLength(1);
  });

  it("is what the map proves, where the search does not", async () => {
    const { run } = program({ state: 1, gap: 0, proved: 0 });
    const result = await run({ kind: "verdict", maps, epsilon: 1 / 600 });
    expect(result).toMatchObject({ verdict: "connected", gap: { lower: 0, upper: 0 }, components: [0, 0] });
  });

  it("is the same along a path", async () => {
    const { run } = program({ state: 2, gap: 8e-4 });
    const points: [number, number][] = [[0.5, 0.5]];
    const result = await run({
      kind: "along",
      from: maps,
      to: maps,
      options: { epsilon: 1 / 600 },
      points,
    });
    expect(result).toEqual([{ verdict: "disconnected", gap: { lower: 0, upper: 1e-3 }, diameter: 1 }]);
  });

  it("is a cause where the morph only looks whole", async () => {
    const { run } = program({ state: 1, gap: 0 });
    const cause = (epsilon: number) =>
      run({ kind: "causes", from: maps, to: maps, options: { epsilon }, points: [[0.5, 0.5]] });
    expect(await cause(1e-6)).toEqual(["apart"]);
    expect(await cause(1 / 600)).toEqual(["near"]);
  });

  it("has what is proved of a polygon family", async () => {
    const { run } = program({ state: 1, gap: 0 });
    const polygon = { sides: 3, s: [0.45, 0.45] as [number, number] };
    const found = { kind: "verdict", maps, epsilon: 1 / 600, polygon } as const;
    const result = await run({ ...found, maps });
    expect(result).toMatchObject({ verdict: "connected" });
  });
});
