/** What pictures are seen before. */
import { NIGHT, PAPER } from "./colours";
import { channelsOf, hexOf } from "./hex";

/** Whether light colours stand out from it. */
export function isDark(colour: string): boolean {
  const part = (at: number) => (Number.parseInt(colour.slice(at, at + 2), 16) / 255) ** 2.2;
  return 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5) < 0.18;
}

/** The same colour, to be changed: by one step where it would be taken for one of the two that have names. */
export function ownFrom(ground: string): string {
  if (ground !== PAPER && ground !== NIGHT) return ground;
  const [red = 0, ...others] = channelsOf(ground);
  return hexOf([red + (ground === PAPER ? -1 : 1), ...others]);
}
