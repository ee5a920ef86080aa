/** What keys do to the picture on the stage, in every tool that draws on it. */
import type { Command } from "#ui/commands";
import { fitStage } from "./gestures";

export const fitCommand = (run: () => void = fitStage): Command => ({
  id: "fit",
  label: "Fit the picture to the window",
  group: "Shape and picture",
  keys: ["F"],
  run,
});
