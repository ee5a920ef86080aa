/** Where two shapes of space meet: the product of their systems as a graph, and shapes to try it with. */

import { formatNumber } from "#format/numbers";
import type { Intersection3, MapRow3, Point3 } from "#wasm/api";

/** All ways from one shift to another. */
export interface Ways {
  from: number;
  to: number;
  /** Pairs of a map of the first shape and one of the second, from 0. */
  pairs: [first: number, second: number][];
}

/** Ways between the same shifts together, in the order in which they are first found. */
export function waysOf({ arrows }: Pick<Intersection3, "arrows">): Ways[] {
  const found = new Map<string, Ways>();
  for (const { from, first, second, to } of arrows) {
    const key = `${from} ${to}`;
    const ways = found.get(key) ?? { from, to, pairs: [] };
    ways.pairs.push([first, second]);
    found.set(key, ways);
  }
  return [...found.values()];
}

/** What stands at an arrow: the pair where it is one, else how many there are. */
export function pairWords(pairs: Ways["pairs"]): string {
  const [only] = pairs;
  return only && pairs.length === 1 ? `${only[0] + 1} · ${only[1] + 1}` : `${pairs.length} ways`;
}

export function shiftWords(shift: Readonly<Point3>): string {
  return `(${shift.map((x) => formatNumber(x, 3)).join(", ")})`;
}

/** The graph in words, for those who do not see it. */
export function graphWords({ shifts, arrows }: Pick<Intersection3, "shifts" | "arrows">): string {
  if (shifts.length === 0) return "No shift goes on for ever: the shapes do not meet.";
  const ways = waysOf({ arrows });
  const listed = ways
    .slice(0, 12)
    .map(
      ({ from, to, pairs }) =>
        `from ${from} to ${to} by ${pairs.length === 1 ? "one pair" : `${pairs.length} pairs`}`,
    );
  const rest = ways.length > 12 ? `, and ${ways.length - 12} more` : "";
  const count = shifts.length === 1 ? "One shift" : `${shifts.length} shifts`;
  return `${count}, of which 0 is none at all. Ways: ${listed.join(", ")}${rest}.`;
}

export type Finding = "apart" | "one" | "several";

/** What the construction comes to. */
export function findingOf({ shifts, attractor }: Pick<Intersection3, "shifts" | "attractor">): Finding {
  if (shifts.length === 0) return "apart";
  return attractor ? "one" : "several";
}

/**
 * Which of the two is made by maps that the other has, too: then all of it lies in the other, and it is what they
 * share. Null where neither is.
 */
export function inner(first: readonly MapRow3[], second: readonly MapRow3[]): "first" | "second" | null {
  const among = (some: readonly MapRow3[], all: readonly MapRow3[]) =>
    some.every((map) => all.some((other) => map.every((x, k) => Math.abs(x - (other[k] ?? 0)) < 1e-12)));
  if (among(first, second)) return "first";
  return among(second, first) ? "second" : null;
}

/** The shape scaled about the origin and then moved: its linear parts stay what they are. */
export function placed(maps: readonly MapRow3[], scale: number, [x, y, z]: Readonly<Point3>): MapRow3[] {
  return maps.map((map) => {
    const [a, b, c, d, e, f, g, h, i, tx, ty, tz] = map;
    // T w T^-1 with T x = scale x + shift (eq 1).
    return [
      ...([a, b, c, d, e, f, g, h, i] as const),
      scale * tx + x - (a * x + b * y + c * z),
      scale * ty + y - (d * x + e * y + f * z),
      scale * tz + z - (g * x + h * y + i * z),
    ];
  });
}

/** Whether all maps have one linear part: only then is there an answer that can be worked out. */
export function sharesLinear(maps: readonly MapRow3[]): boolean {
  const [first] = maps;
  return (
    first !== undefined &&
    maps.every((map) => map.slice(0, 9).every((x, k) => Math.abs(x - (first[k] ?? 0)) < 1e-12))
  );
}

/** Whether a shape lies flat at one height. */
export function isFlat(maps: readonly MapRow3[]): boolean {
  return maps.every((map) => map[11] === 0 && map[6] === 0 && map[7] === 0);
}
