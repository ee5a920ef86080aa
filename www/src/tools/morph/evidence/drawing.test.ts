import { expect, test } from "vitest";
import type { Link, MapRow } from "#wasm/api";
import { evidenceDrawing } from "./drawing";

const half = (x: number, y: number): MapRow => [0.5, 0, 0, 0.5, x, y];
const square: [number, number][] = [
  [0, 0],
  [2, 0],
  [2, 1],
  [0, 1],
];
const link: Link = { kind: "point", pair: [0, 1], words: ["1(2)", "2(1)"], at: [1, 0.5] };
const plain = {
  title: "Mine <b>",
  words: "In one piece.",
  maps: [half(0, 0), half(1, 0), half(0, 0.5), half(1, 0.5)],
  hull: square,
  colours: ["#c47800", "#0072b2"],
  links: [link],
  sides: [],
  gap: null,
};

test("a drawing has the shape in its pieces, and what joins them where they meet", () => {
  const text = evidenceDrawing(plain);
  expect(text).toContain("<title>Mine &lt;b&gt;</title>");
  const [, said] = /<desc>In one piece\. ([\d,]+) pieces of the shape/.exec(text) ?? [];
  const count = Number(said?.replaceAll(",", ""));
  expect(text.match(/Z/g)?.length).toBe(count);
  expect(count).toBeGreaterThan(500);
  expect(count).toBeLessThanOrEqual(3000);
  // 450 pixels a unit and a margin of 30; the point is in the middle, and y points down in a file.
  expect(text).toContain('viewBox="0 0 960 510"');
  expect(text.match(/<circle cx="480" cy="255" r="7"/g)?.length).toBe(2);
  const numbers = [...text.matchAll(/[ML](-?[\d.]+) (-?[\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)]);
  expect(numbers.every(([x = -1, y = -1]) => x >= 30 && x <= 930 && y >= 30 && y <= 480)).toBe(true);
});

test("crossing chords, pieces of a proof and the gap are drawn where they are", () => {
  const corners: [number, number][] = [
    [0, 0],
    [2, 1],
    [0, 1],
    [2, 0],
  ];
  const text = evidenceDrawing({
    ...plain,
    links: [{ ...link, kind: "crossing", corners }],
    sides: [{ side: 1, corners: square }],
    gap: { from: [0.5, 0], to: [1.5, 0], words: "50% & more" },
  });
  expect(text).toContain('d="M30 480L930 30" fill="none" stroke="#000000"');
  expect(text).toContain('d="M30 480L930 480L930 30L30 30Z" fill="#1d1e22"');
  expect(text).toContain('d="M255 480L705 480" fill="none" stroke="#b3321d"');
  expect(text).toContain("50% &amp; more</text>");
});

test("what cannot be cut is one piece", () => {
  const text = evidenceDrawing({ ...plain, maps: [half(0, 0)], links: [] });
  expect(text).toContain("In one piece. One piece");
  // Pieces that never become small do not take all time.
  const slow: MapRow = [0.9999, 0, 0, 0.9999, 0, 0];
  expect(evidenceDrawing({ ...plain, maps: [slow, slow], links: [] }).length).toBeLessThan(2_000_000);
});
