import { expect, it } from "vitest";
import { screen } from "#geometry/coordinates";
import { apart } from "./apart";

const least = (places: readonly { x: number; y: number }[]) =>
  Math.min(...places.flatMap((p, i) => places.slice(i + 1).map((q) => Math.hypot(p.x - q.x, p.y - q.y))));

it("leaves what is apart where it is", () => {
  const places = [screen(0, 0), screen(40, 0), screen(0, 40)];
  expect(apart(places, 26)).toEqual(places);
});

it("puts what lies on each other side by side, in order", () => {
  const all = apart([screen(5, 5), screen(5, 5), screen(12, 20), screen(5, 6)], 26);
  expect(all[0]).toEqual(screen(5, 5));
  expect(least(all)).toBeGreaterThanOrEqual(26);
  expect(all.map(({ y }) => y)).toEqual([5, 5, 20, 6]);
  // As many as a shape may have.
  const many = apart(
    Array.from({ length: 64 }, () => screen(0, 0)),
    26,
  );
  expect(least(many)).toBeGreaterThanOrEqual(26);
});
