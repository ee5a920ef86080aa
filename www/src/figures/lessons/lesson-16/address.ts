/** Names of digits for the pieces and points of a shape of up to nine maps. */
import type { MapRow } from "#wasm/api";
import { fixedPoint } from "../../kit/maps/families";
import { apply, compose, type Point } from "../../kit/maps/pieces";

/** Digits, from the largest piece to smaller ones; `again` is what is said for ever after. */
export interface Address {
  first: readonly number[];
  again: readonly number[];
}

const MOST_FIRST = 12;
const MOST_AGAIN = 8;

/** Reads "13" as a piece and "1(2)" as a point; what is wrong with it, in words, where it is neither. */
export function readAddress(text: string, maps: number): Address | string {
  const match = /^(\d*)(?:\((\d*)\)?)?$/.exec(text.replace(/\s/g, ""));
  if (!match) return "Write digits, and those that come again and again in brackets at the end, as in 1(2).";
  const digits = (part: string | undefined) => [...(part ?? "")].map(Number);
  const [first, again] = [digits(match[1]), digits(match[2])];
  const wrong = [...first, ...again].find((digit) => digit < 1 || digit > maps);
  if (wrong !== undefined) return `There is no piece ${wrong}: the digits are 1 to ${maps}.`;
  if (first.length > MOST_FIRST) return `At most ${MOST_FIRST} digits before the brackets.`;
  if (again.length > MOST_AGAIN) return `At most ${MOST_AGAIN} digits in the brackets.`;
  return { first: first.map((digit) => digit - 1), again: again.map((digit) => digit - 1) };
}

const STILL: MapRow = [1, 0, 0, 1, 0, 0];
const along = (maps: readonly MapRow[], letters: readonly number[]) =>
  letters.reduce((map, letter) => compose(map, maps[letter] ?? STILL), STILL);

/** The map that makes the piece of the digits before the brackets. */
export function pieceOf(maps: readonly MapRow[], { first }: Address): MapRow {
  return along(maps, first);
}

/** The point that an address without end leads to; null for that of a piece. */
export function pointOf(maps: readonly MapRow[], { first, again }: Address): Point | null {
  if (again.length === 0) return null;
  // What is said again and again leads to the point that those maps together leave in place.
  return apply(along(maps, first), fixedPoint(along(maps, again)));
}

/** The first digits of an address, from 0: as many as are asked for, or all there are. */
export function firstDigits({ first, again }: Address, count: number): number[] {
  const digits = first.slice(0, count);
  for (let i = 0; again.length > 0 && digits.length < count; i++) digits.push(again[i % again.length] ?? 0);
  return digits;
}

/** Whether two addresses without end have the same digits, however they are written: 1(2) is 12(22). */
export function isSameAddress(one: Address, other: Address): boolean {
  // Once both repeat, they agree for ever if they do for as long as both rounds together.
  const enough = Math.max(one.first.length, other.first.length) + one.again.length + other.again.length;
  return firstDigits(one, enough).join() === firstDigits(other, enough).join();
}
