import { formatNumber } from "#format/numbers";
import type { IconName } from "#ui/controls/Icon";
import type { Ease, Repeat, SpaceKey, SpaceTimeline } from "#wasm/api";
import * as messages from "./messages";
import { keyAt } from "./time-edits";

/** How it goes on from a key. */
export const EASES: readonly { value: Ease; label: string }[] = [
  { value: "even", label: messages.atConstantSpeed },
  { value: "in", label: messages.slowAtFirst },
  { value: "out", label: messages.slowAtEnd },
  { value: "inout", label: messages.slowAtBothEnds },
  { value: "hold", label: messages.holdThenJump },
];

/** What comes after the end. */
export const LOOPS: readonly { value: Repeat; label: string; description: string; icon: IconName }[] = [
  { value: "once", label: messages.none2, description: messages.stopsAtEnd, icon: "once" },
  {
    value: "round",
    label: messages.restart,
    description: messages.startsAgainLastKeyframe,
    icon: "loop",
  },
  {
    value: "pingpong",
    label: messages.backAndForth,
    description: messages.playsInReverseFrom,
    icon: "swing",
  },
];

export const loopOf = (loop: Repeat) => LOOPS.find(({ value }) => value === loop) ?? LOOPS[0];

export const easeWords = (ease: Ease): string =>
  EASES.find(({ value }) => value === ease)?.label.toLowerCase() ?? ease;

export const secondsWords = (at: number): string => `${formatNumber(at, 2)} s`;

/** Where in time, and whether there is a key. */
export function momentWords(line: SpaceTimeline | null, at: number): string {
  if (!line) return messages.nothingMoves(secondsWords(at));
  const near = keyAt(line, at);
  const key = near < 0 ? messages.betweenKeyframes2 : messages.keyCount(near + 1, line.keys.length);
  return messages.momentOf(secondsWords(at), secondsWords(line.seconds), key);
}

/** What a key says. */
export function keyWords({ view, moved, maps, bends, t }: SpaceKey): string {
  const objects = new Set<number>();
  for (const list of [moved, maps, bends]) {
    for (const [i, item] of (list ?? []).entries()) if (item) objects.add(i);
  }
  const parts = [
    ...(view ? [messages.view2] : []),
    ...(objects.size > 0
      ? [objects.size === 1 ? messages.oneObject : messages.objectsMoved(objects.size)]
      : []),
    ...(t === undefined ? [] : [messages.morphAt(formatNumber(t, 2))]),
  ];
  return parts.length > 0 ? parts.join(", ") : messages.nothingYet;
}
