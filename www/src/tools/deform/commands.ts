/** What keys do while the deformation tool is open. */
import { deformation, phasePlaying } from "#document/deform/bend";
import { edit } from "#document/scene";
import { fitCommand, handCommand } from "#stage/commands";
import { type Command, everywhere } from "#ui/commands";
import { type Timeline, timeCommands } from "#ui/strip/timeline";
import type { Colouring } from "#wasm/api";
import { pausePhase, playPhase, scrubPhase } from "./clock";
import { gallery } from "./dialogs";
import { hand } from "./mesh/handles/hand";
import { gridShown } from "./mesh/shown";
import { addKey } from "./strip/TimeOptions";
import { withColouring } from "./tint";

/** The moment of the next key in a direction, round the end where it loops; the same moment where there is none. */
export function nextKey(moments: readonly number[], phase: number, by: 1 | -1, loop: boolean): number {
  const ahead = by > 0 ? moments.find((x) => x > phase + 1e-3) : moments.findLast((x) => x < phase - 1e-3);
  return ahead ?? (loop ? moments.at(by > 0 ? 0 : -1) : undefined) ?? phase;
}

const TIME: Timeline = {
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

const COLOURS: readonly Colouring[] = ["map", "address", "density", "grid"];
const KEY = "Key frame, in focus";
const HANDLE = "Handle of the grid, in focus";
const SHAPE = "Shape and picture";

export const commands: readonly Command[] = [
  ...timeCommands(TIME),
  { id: "key", label: "Add a key frame", group: "Time", keys: ["K"], run: addKey },
  { id: "key-move", label: "Move in time; Shift finer, Alt farther", group: KEY, keys: ["←", "→"] },
  { id: "key-next", label: "To its neighbour", group: KEY, keys: ["[", "]"] },
  { id: "key-delete", label: "Delete it", group: KEY, keys: ["Delete", "−"] },
  {
    id: "handle-move",
    label: "Move it; Shift farther, Alt finer",
    group: HANDLE,
    keys: ["←", "→", "↑", "↓"],
  },
  { id: "handle-next", label: "To the handle before, after", group: HANDLE, keys: ["[", "]"] },
  { id: "handle-neighbour", label: "To its neighbour", group: HANDLE, keys: ["Ctrl+←"] },
  { id: "handle-choose", label: "Choose it, let it go", group: HANDLE, keys: ["Space"] },
  { id: "handle-all", label: "Choose all", group: HANDLE, keys: ["Ctrl+A"] },
  { id: "handle-back", label: "Put it back", group: HANDLE, keys: ["Delete"] },
  {
    id: "gallery",
    label: "Gallery",
    group: SHAPE,
    keys: ["G"],
    run: () => {
      gallery.value = true;
    },
  },
  handCommand(hand, ["move", "pull", "choose"], {
    label: "What a drag does, the next, the one before: move, pull, select",
    group: SHAPE,
    enabled: () => gridShown.peek(),
  }),
  {
    id: "hide",
    label: "Hide the grid, show it",
    group: SHAPE,
    keys: ["H"],
    run: () => {
      gridShown.value = !gridShown.peek();
    },
  },
  fitCommand(),
  {
    id: "colour",
    label: "Colour by map, address, density, grid",
    group: SHAPE,
    keys: ["1", "2", "3", "4"],
    run: (way) => edit((before) => withColouring(before, COLOURS[way] ?? "map", deformation.peek())),
  },
  ...everywhere(),
];
