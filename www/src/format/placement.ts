import type { Place3, Point3 } from "#wasm/api";
import * as messages from "./messages";
import { formatNumber } from "./numbers";

/** What was done to an object, as a hand would say it. */
export function placeWords(place: Place3 | null): string {
  if (!place) return messages.changeWithNoSimple;
  const { shift, turn, scale, exact } = place;
  const words: string[] = [];
  const even = Math.max(...scale) - Math.min(...scale) < 1e-6 * Math.max(...scale.map(Math.abs));
  if (even && Math.abs(scale[0] - 1) > 1e-6) words.push(messages.scaledBy(formatNumber(scale[0], 3)));
  else if (!even) words.push(messages.scaledBy(scale.map((x) => formatNumber(x, 3)).join(", ")));
  const half = Math.hypot(turn[0], turn[1], turn[2]);
  const angle = (2 * Math.atan2(half, Math.abs(turn[3])) * 180) / Math.PI;
  if (angle > 0.005) {
    const sign = turn[3] < 0 ? -1 : 1;
    const axis = [turn[0], turn[1], turn[2]].map((x) => (sign * x) / half) as Point3;
    words.push(messages.rotatedBy(formatNumber(angle, 2), axisWords(axis)));
  }
  if (Math.hypot(...shift) > 1e-9)
    words.push(messages.movedBy(shift.map((x) => formatNumber(x, 3)).join(", ")));
  if (!exact) words.push(messages.andAlsoShearedOr);
  return words.length > 0 ? words.join(", ") : "nothing";
}

const ALONG_AXIS = 1e-6;

/** A direction by its axis, where it is one; else by its numbers. */
export function axisWords(direction: Point3): string {
  const along = ["x", "y", "z"].find((_, k) => Math.abs(Math.abs(direction[k] ?? 0) - 1) < ALONG_AXIS);
  if (along) return (direction[["x", "y", "z"].indexOf(along)] ?? 0) < 0 ? `−${along}` : along;
  return `(${direction.map((x) => formatNumber(x, 3)).join(", ")})`;
}

/** Of length 1; null where there is no direction. */
export function unit([x, y, z]: Point3): Point3 | null {
  const length = Math.hypot(x, y, z);
  return length > 1e-12 && Number.isFinite(length) ? [x / length, y / length, z / length] : null;
}

/** A number that grows as 1 / epsilon: it stands in the third column where none is given. */
export type Diverging = readonly [map: number, row: number, column?: number];

const ORDINALS = [messages.first, messages.second, messages.third];

/** Places of numbers that grow as 1 / epsilon, as people read them: "row 2 of w₁". */
export function divergingWords(diverging: readonly Diverging[]): string {
  if (diverging.length === 0) return messages.noNumberGrowsEvery;
  const [[, , first = 2] = [0, 0]] = diverging;
  const one = diverging.every(([, , column = 2]) => column === first);
  const few = diverging.slice(0, 6).map(([map, row, column = 2]) => {
    const place = one ? messages.row(row + 1) : messages.cell(row + 1, column + 1);
    return messages.cellOf(place, lowered(map + 1));
  });
  const more = diverging.length - few.length;
  const list = few.join(one ? ", " : "; ") + (more > 0 ? messages.andMore(more) : "");
  const column = one ? messages.inColumn(ORDINALS[first] ?? messages.third) : "";
  return messages.numbersGrow(diverging.length, column, list);
}

function lowered(n: number): string {
  return String(n).replace(/\d/g, (digit) => "₀₁₂₃₄₅₆₇₈₉".at(Number(digit)) ?? digit);
}
