import { formatNumber } from "#format/numbers";
import type { IconName } from "#ui/controls/Icon";
import type { Ease, Repeat, SpaceKey, SpaceTimeline } from "#wasm/api";
import { keyAt } from "./changes";

/** How it goes on from a key. */
export const EASES: readonly { value: Ease; label: string }[] = [
  { value: "even", label: "At an even pace" },
  { value: "in", label: "Slow at first" },
  { value: "out", label: "Slow at the end" },
  { value: "inout", label: "Slow at both ends" },
  { value: "hold", label: "Stay, then jump" },
];

/** What comes after the end. */
export const LOOPS: readonly { value: Repeat; label: string; description: string; icon: IconName }[] = [
  { value: "once", label: "Once", description: "It stops at its end", icon: "once" },
  {
    value: "round",
    label: "Round and round",
    description: "It begins again: the last key goes on to the first, and from the very end it jumps there",
    icon: "loop",
  },
  { value: "pingpong", label: "To and fro", description: "It goes back the way it came", icon: "swing" },
];

export const loopOf = (loop: Repeat) => LOOPS.find(({ value }) => value === loop) ?? LOOPS[0];

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
export function keyWords({ view, moved, maps, bends, t }: SpaceKey): string {
  const objects = new Set<number>();
  for (const list of [moved, maps, bends]) {
    for (const [i, item] of (list ?? []).entries()) if (item) objects.add(i);
  }
  const parts = [
    ...(view ? ["the view"] : []),
    ...(objects.size > 0 ? [objects.size === 1 ? "one object" : `${objects.size} objects`] : []),
    ...(t === undefined ? [] : [`the morph at ${formatNumber(t, 2)}`]),
  ];
  return parts.length > 0 ? parts.join(", ") : "nothing yet";
}
