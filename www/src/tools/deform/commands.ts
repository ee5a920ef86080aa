/** What keys do while the deformation tool is open. */
import { deformation, phasePlaying } from "#document/deform/bend";
import { edit } from "#document/scene";
import { standIn } from "#document/stand-in";
import { colourCommand, fitCommand, galleryCommand, handCommand, switchCommand } from "#stage/commands";
import { type Command, everywhere, widgetKeys } from "#ui/commands";
import { exportCommand } from "#ui/files/exporting";
import type { Timeline } from "#ui/strip/timeline";
import { pausePhase, playPhase, scrubPhase } from "./clock";
import { gallery } from "./dialogs";
import { unbent } from "./facts";
import { hand } from "./mesh/handles/hand";
import { gridShown } from "./mesh/shown";
import { addKey } from "./strip/TimeOptions";
import { withColouring } from "./tint";

/** The moment of the next key in a direction, round the end where it loops; the same moment where there is none. */
export function nextKey(moments: readonly number[], phase: number, by: 1 | -1, loop: boolean): number {
  const ahead = by > 0 ? moments.find((x) => x > phase + 1e-3) : moments.findLast((x) => x < phase - 1e-3);
  return ahead ?? (loop ? moments.at(by > 0 ? 0 : -1) : undefined) ?? phase;
}

export const timeline: Timeline = {
  now: () => deformation.peek().phase,
  length: () => 1,
  seek: scrubPhase,
  toggle: () => (phasePlaying.peek() ? pausePhase() : playPhase()),
  step(by) {
    const { keys, phase, loop } = deformation.peek();
    const moments = keys.map((key) => key.at);
    scrubPhase(nextKey(moments, phase, by, loop));
  },
  stop: "key frame",
};

const SHAPE = "Shape and picture";

export const commands: readonly Command[] = [
  { id: "key", label: "Add a key frame", group: "Time", keys: ["K"], run: addKey },
  ...widgetKeys("Key frame, in focus", [
    ["key-move", "Move in time; Shift finer, Alt farther", "←", "→"],
    ["key-next", "To its neighbour", "[", "]"],
    ["key-delete", "Delete it", "Delete", "−"],
  ]),
  ...widgetKeys("Handle of the grid, in focus", [
    ["handle-move", "Move it; Shift farther, Alt finer", "←", "→", "↑", "↓"],
    ["handle-next", "To the handle before, after", "[", "]"],
    ["handle-neighbour", "To its neighbour", "Ctrl+←"],
    ["handle-choose", "Choose it, let it go", "Space"],
    ["handle-all", "Choose all", "Ctrl+A"],
    ["handle-back", "Put it back", "Delete"],
  ]),
  galleryCommand(SHAPE, () => {
    gallery.value = true;
  }),
  handCommand(hand, ["move", "pull", "choose"], {
    label: "What a drag does, the next, the one before: move, pull, select",
    group: SHAPE,
    enabled: () => gridShown.peek() && !unbent.peek(),
  }),
  switchCommand(gridShown, { id: "hide", label: "Hide the grid, show it", group: SHAPE, keys: ["H"] }),
  fitCommand(),
  colourCommand(["map", "address", "density", "grid"], SHAPE, (colouring) =>
    edit((before) => withColouring(before, colouring, deformation.peek())),
  ),
  exportCommand(() => !standIn.peek()),
  ...everywhere(),
];
