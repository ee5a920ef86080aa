/** What keys do to the picture on the stage, in every tool that draws on it. */
import type { Signal } from "@preact/signals";
import type { Command } from "#ui/commands";
import { fitStage } from "./gestures";

export const fitCommand = (run: () => void = fitStage): Command => ({
  id: "fit",
  label: "Fit the picture to the window",
  group: "Shape and picture",
  keys: ["F"],
  run,
});

/** What a drag does: the next in a row, or the one before. */
export const handCommand = <Hand>(
  hand: Signal<Hand>,
  hands: readonly Hand[],
  words: Pick<Command, "label" | "group" | "enabled">,
): Command => ({
  id: "hand",
  keys: ["M", "Shift+M"],
  run(way) {
    const next = hands.indexOf(hand.peek()) + (way === 0 ? 1 : hands.length - 1);
    hand.value = hands[next % hands.length] ?? hand.peek();
  },
  ...words,
});
