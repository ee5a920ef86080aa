/** What keys do to the picture on the stage, in every tool that draws on it. */
import type { Signal } from "@preact/signals";
import type { Command } from "#ui/commands";
import type { Colouring } from "#wasm/api";
import { fitStage } from "./gestures";
import * as messages from "./messages";

export const fitCommand = (run: () => void = fitStage): Command => ({
  id: "fit",
  label: messages.fitPictureToWindow,
  group: messages.shapeAndPicture,
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

/** Turns something on and off. */
export const switchCommand = (
  on: Signal<boolean>,
  words: Pick<Command, "id" | "label" | "group" | "keys">,
): Command => ({
  ...words,
  run: () => {
    on.value = !on.peek();
  },
});

/** The first by the key 1, and so on. */
export const colourCommand = (
  colours: readonly Colouring[],
  group: string,
  choose: (colouring: Colouring) => void,
): Command => ({
  id: "colour",
  label: messages.colourBy(colours.join(", ")),
  group,
  keys: colours.map((_, i) => `${i + 1}`),
  run: (way) => choose(colours[way] ?? "map"),
});

export const galleryCommand = (group: string, run: () => void): Command => ({
  id: "gallery",
  label: messages.gallery,
  group,
  keys: ["G"],
  run,
});
