import { expect, it, vi } from "vitest";
import type { MapRow } from "#wasm/api";
import type { Job } from "#workers/pool/protocol";

vi.mock("#wasm/core", () => ({ frond: {} }));
const jobs: Job<"picture">[] = [];
vi.mock("#workers/pool/engine", () => ({
  epoch: { value: 0 },
  submit: (job: Job<"picture">) => jobs.push(job),
}));

const { inOrder, thumbnailsOf } = await import("./thumbnails");

const [p, q, r]: [MapRow, MapRow, MapRow] = [
  [0.5, 0, 0, 0.5, 0, 0],
  [0.5, 0, 0, 0.5, 0.5, 0],
  [0.5, 0, 0, 0.5, 0.25, 0.5],
];
const copy = (map: MapRow): MapRow => [...map];

it("gives each map of an end the place, and so the colour, that it has in the morph", () => {
  const own = [p, q];
  expect(inOrder(own, [copy(p), copy(q)])).toBe(own);
  expect(inOrder(own, [copy(p), copy(p), copy(q)])).toEqual([p, p, q]);
  expect(inOrder([p, q, r], [p, q, r], [2, 0, 1])).toEqual([r, p, q]);
});

it("shows an end as it is where the morph has other maps", () => {
  const own = [p, q];
  // Split pieces, the pair before, and an order that is not one of them.
  expect(inOrder(own, [p, r, r])).toBe(own);
  expect(inOrder(own, [r, r])).toBe(own);
  expect(inOrder(own, [p, q], [0, 5])).toBe(own);
});

it("draws no picture again of maps that are as they were", async () => {
  const tasks = (maps: MapRow[]) => {
    thumbnailsOf([{ id: "one", maps }]);
    return vi.waitFor(() => {
      const job = jobs.at(-1);
      if (!job) throw new Error("none yet");
      return [job.next()?.maps, job.next()];
    });
  };
  expect(await tasks([p, q])).toEqual([[p, q], null]);
  expect(await tasks([copy(p), copy(q)])).toEqual([undefined, null]);
  expect(await tasks([copy(p), r])).toEqual([[p, r], null]);
});
