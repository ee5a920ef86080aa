/** What keys do while the deformation tool is open. */
import { deformation, phasePlaying } from "#document/deform/bend";
import { edit } from "#document/scene";
import { standIn } from "#document/stand-in";
import { colourCommand, fitCommand, galleryCommand, handCommand, switchCommand } from "#stage/commands";
import { type Command, everywhere, widgetKeys } from "#ui/commands";
import { exportCommand } from "#ui/files/exporting";
import type { Timeline } from "#ui/strip/timeline";
import { pausePhase, playPhase, scrubPhase } from "./clock";
import { unbent } from "./facts";
import { gridShown, hand } from "./mesh/mesh-state";
import * as messages from "./messages";
import { gallery } from "./shape/ShapePanel";
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
  stop: messages.keyframe,
};

const SHAPE = messages.shapeAndPicture;

export const commands: readonly Command[] = [
  { id: "key", label: messages.addKeyframe, group: messages.time, keys: ["K"], run: addKey },
  ...widgetKeys(messages.keyframeFocused, [
    ["key-move", messages.moveInTimeShift, "←", "→"],
    ["key-next", messages.toNextOne, "[", "]"],
    ["key-delete", messages.deleteLabel, messages.deleteLabel2, "−"],
  ]),
  ...widgetKeys(messages.handleGridFocused, [
    ["handle-move", messages.moveShiftCoarserAlt, "←", "→", "↑", "↓"],
    ["handle-next", messages.toHandleBeforeOr, "[", "]"],
    ["handle-neighbour", messages.toNextOne, "Ctrl+←"],
    ["handle-choose", messages.selectDeselect, "Space"],
    ["handle-all", messages.selectAll, "Ctrl+A"],
    ["handle-back", messages.reset, messages.deleteLabel2],
  ]),
  galleryCommand(SHAPE, () => {
    gallery.value = true;
  }),
  handCommand(hand, ["move", "pull", "choose"], {
    label: messages.nextOrPreviousDrag,
    group: SHAPE,
    enabled: () => gridShown.peek() && !unbent.peek(),
  }),
  switchCommand(gridShown, { id: "hide", label: messages.hideOrShowGrid, group: SHAPE, keys: ["H"] }),
  fitCommand(),
  colourCommand(["map", "address", "density", "grid"], SHAPE, (colouring) =>
    edit((before) => withColouring(before, colouring, deformation.peek())),
  ),
  exportCommand(() => !standIn.peek()),
  ...everywhere(),
];
