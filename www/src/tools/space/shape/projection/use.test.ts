import { expect, test } from "vitest";
import { AT_REST } from "#document/deform/bend";
import { scene } from "#document/scene";
import type { MapRow } from "#wasm/api";
import { different, tidy, withA } from "./use";

const half: MapRow = [0.5, 0, 0, 0.5, 0, 0];

test("a shadow loses its dust, and nothing else", () => {
  expect(tidy([[0.5000000000000001, 1e-17, -3e-16, 0.5, 1 / 3, 1e-9]])).toEqual([
    [0.5, 0, 0, 0.5, 0.333333333333, 1e-9],
  ]);
});

test("maps that are the same but for dust are one", () => {
  expect(different([half, [0.5, 0, 0, 0.5, 1e-13, 0], [0.5, 0, 0, 0.5, 0.5, 0]])).toHaveLength(2);
});

test("it becomes A at the start of the morph, with the grid around it", () => {
  const before = {
    ...scene.peek(),
    t: 0.7,
    correspondence: [1, 0, 2],
    turns: [0, 1, 0],
    view: { x: 1, y: 1, zoom: 9 },
    deform: { ...AT_REST, subject: "picture" as const },
  };
  const after = withA(before, { name: "Shadow", maps: [half] }, [3, 4, 5, 6]);
  expect(after.a).toEqual({ name: "Shadow", maps: [half] });
  expect(after.b).toEqual(before.b);
  expect([after.t, after.correspondence, after.turns, "view" in after]).toEqual([0, [], [], false]);
  expect([after.deform?.subject, after.deform?.box]).toEqual(["shape", [3, 4, 5, 6]]);
  const { deform: _, ...plain } = before;
  expect("deform" in withA(plain, { name: "Shadow", maps: [half] }, [0, 0, 1, 1])).toBe(false);
});
