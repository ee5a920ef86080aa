import type { Ease, SpaceKey, SpaceTimeline } from "../../../engine/api";
import { formatNumber } from "../../../ui/number";
import { keyAt } from "./changes";

/** How it goes on from a key. */
export const EASES: readonly { value: Ease; label: string }[] = [
  { value: "even", label: "At an even pace" },
  { value: "in", label: "Slow at first" },
  { value: "out", label: "Slow at the end" },
  { value: "inout", label: "Slow at both ends" },
  { value: "hold", label: "Stay, then jump" },
];

export const easeWords = (ease: Ease): string =>
  EASES.find(({ value }) => value === ease)?.label.toLowerCase() ?? ease;

export const secondsWords = (at: number): string => `${formatNumber(at, 2)} s`;

/** Where in time, and whether there is a key. */
export function momentWords(line: SpaceTimeline | null, at: number): string {
  if (!line) return `${secondsWords(at)}, nothing moves`;
  const near = keyAt(line, at);
  const key = near < 0 ? "between keys" : `key ${near + 1} of ${line.keys.length}`;
  return `${secondsWords(at)} of ${secondsWords(line.seconds)}, ${key}`;
}

/** What a key says. */
export function keyWords({ view, moved, maps, t }: SpaceKey): string {
  const objects = new Set<number>();
  for (const list of [moved, maps]) {
    for (const [i, item] of (list ?? []).entries()) if (item) objects.add(i);
  }
  const parts = [
    ...(view ? ["the view"] : []),
    ...(objects.size > 0 ? [objects.size === 1 ? "one object" : `${objects.size} objects`] : []),
    ...(t === undefined ? [] : [`the morph at ${formatNumber(t, 2)}`]),
  ];
  return parts.length > 0 ? parts.join(", ") : "nothing yet";
}
