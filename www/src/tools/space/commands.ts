/** What keys do while space is open. */
import { EMPTY_LINE } from "#document/space/edits";
import { hand, timeline as line, moment } from "#document/space/space";
import { fitCommand, handCommand } from "#stage/commands";
import { type Command, everywhere, widgetKeys } from "#ui/commands";
import { exportCommand } from "#ui/files/exporting";
import type { Timeline } from "#ui/strip/timeline";
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

const DRAG = "What a drag does";
const PLACES = "Places to look from";

export const commands: readonly Command[] = [
  handCommand(hand, ["look", "turn", "move", "scale"], {
    label: "The next, the one before: look around; turn, move, scale the object",
    group: DRAG,
  }),
  ...widgetKeys(DRAG, [["drag-shift", "Held while dragging: shift what is seen", "Shift"]]),
  ...widgetKeys("Where the picture has the focus", [
    ["stage-move", "What a drag does; with Shift, shift what is seen", "←", "→", "↑", "↓"],
    ["stage-zoom", "Nearer, farther", "+", "−"],
    ["stage-fly", "Fly ahead, left, back, right; Shift finer", "W", "A", "S", "D"],
    ["stage-rise", "Fly down, up", "Q", "E"],
    ["size", "A smaller angle of view, a larger one", ",", "."],
  ]),
  { ...fitCommand(showWhole), label: "All of it", group: PLACES, keys: ["0", "F"] },
  { id: "origin", label: "From the origin", group: PLACES, keys: ["O"], run: goToOrigin },
  { id: "key", label: "Set a key", group: "Time", keys: ["K"], run: setKey },
  ...widgetKeys("Key, in focus", [
    ["key-move", "Move it by 0.1 s; Shift finer, Alt farther", "←", "→"],
    ["key-go", "Go there", "Enter"],
    ["key-next", "To its neighbour", "[", "]"],
    ["key-delete", "Delete it", "Delete", "−"],
  ]),
  exportCommand(),
  ...everywhere(),
];
