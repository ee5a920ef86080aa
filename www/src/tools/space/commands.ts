/** What keys do while space is open. */
import { EMPTY_LINE } from "#document/space/edits";
import { hand, moment, timeline } from "#document/space/space";
import { fitCommand, handCommand } from "#stage/commands";
import { type Command, everywhere } from "#ui/commands";
import { type Timeline, timeCommands } from "#ui/strip/timeline";
import { goToOrigin, showWhole } from "./stage/actions";
import { scrubSpace, togglePlay } from "./time/clock";
import { goToKey, setKey } from "./time/keys/keys";

const TIME: Timeline = {
  now: () => moment.peek(),
  length: () => (timeline.peek() ?? EMPTY_LINE).seconds,
  seek: scrubSpace,
  toggle: togglePlay,
  step: goToKey,
  stop: "key",
};

const DRAG = "What a drag does";
const STAGE = "Where the picture has the focus";
const PLACES = "Places to look from";
const KEY = "Key, in focus";

export const commands: readonly Command[] = [
  handCommand(hand, ["look", "turn", "move", "scale"], {
    label: "The next, the one before: look around; turn, move, scale the object",
    group: DRAG,
  }),
  { id: "drag-shift", label: "Held while dragging: shift what is seen", group: DRAG, keys: ["Shift"] },
  {
    id: "stage-move",
    label: "What a drag does; with Shift, shift what is seen",
    group: STAGE,
    keys: ["←", "→", "↑", "↓"],
  },
  { id: "stage-zoom", label: "Nearer, farther", group: STAGE, keys: ["+", "−"] },
  {
    id: "stage-fly",
    label: "Fly ahead, left, back, right; Shift finer",
    group: STAGE,
    keys: ["W", "A", "S", "D"],
  },
  { id: "stage-rise", label: "Fly down, up", group: STAGE, keys: ["Q", "E"] },
  { id: "size", label: "A smaller angle of view, a larger one", group: STAGE, keys: [",", "."] },
  { ...fitCommand(showWhole), label: "All of it", group: PLACES, keys: ["0", "F"] },
  { id: "origin", label: "From the origin", group: PLACES, keys: ["O"], run: goToOrigin },
  ...timeCommands(TIME),
  { id: "key", label: "Set a key", group: "Time", keys: ["K"], run: setKey },
  { id: "key-move", label: "Move it by 0.1 s; Shift finer, Alt farther", group: KEY, keys: ["←", "→"] },
  { id: "key-go", label: "Go there", group: KEY, keys: ["Enter"] },
  { id: "key-next", label: "To its neighbour", group: KEY, keys: ["[", "]"] },
  { id: "key-delete", label: "Delete it", group: KEY, keys: ["Delete", "−"] },
  ...everywhere(),
];
