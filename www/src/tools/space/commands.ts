/** What keys do while space is open. */
import { EMPTY_LINE } from "#document/space/edits";
import { hand, timeline as line, moment } from "#document/space/space";
import { fitCommand, handCommand } from "#stage/commands";
import { type Command, everywhere, widgetKeys } from "#ui/commands";
import { exportCommand } from "#ui/files/exporting";
import type { Timeline } from "#ui/strip/timeline";
import * as messages from "./messages";
import { goToOrigin, showWhole } from "./stage/actions";
import { scrubSpace, togglePlay } from "./time/clock";
import { goToKey, setKey } from "./time/keys/keys";

export const timeline: Timeline = {
  now: () => moment.peek(),
  length: () => (line.peek() ?? EMPTY_LINE).seconds,
  seek: scrubSpace,
  toggle: togglePlay,
  step: goToKey,
  stop: "key",
};

const DRAG = messages.dragMode;
const PLACES = messages.viewpoints;

export const commands: readonly Command[] = [
  handCommand(hand, ["look", "turn", "move", "scale"], {
    label: messages.nextOrPreviousDrag,
    group: DRAG,
  }),
  ...widgetKeys(DRAG, [["drag-shift", messages.holdWhileDraggingPan, "Shift"]]),
  ...widgetKeys(messages.withPictureFocused, [
    ["stage-move", messages.asDragModeSays, "←", "→", "↑", "↓"],
    ["stage-zoom", messages.zoomInZoomOut, "+", "−"],
    ["stage-fly", messages.flyForwardLeftBack, "W", "A", "S", "D"],
    ["stage-rise", messages.flyDownUp, "Q", "E"],
    ["size", messages.decreaseOrIncreaseAngle, ",", "."],
  ]),
  { ...fitCommand(showWhole), label: messages.showAll, group: PLACES, keys: ["0", "F"] },
  { id: "origin", label: messages.fromOrigin, group: PLACES, keys: ["O"], run: goToOrigin },
  { id: "key", label: messages.setKeyframe, group: messages.time, keys: ["K"], run: setKey },
  ...widgetKeys(messages.keyframeFocused, [
    ["key-move", messages.moveBy01, "←", "→"],
    ["key-go", messages.goThere, "Enter"],
    ["key-next", messages.toNextOne, "[", "]"],
    ["key-delete", messages.deleteLabel, "Delete", "−"],
  ]),
  exportCommand(),
  ...everywhere(),
];
