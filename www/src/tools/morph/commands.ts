/** What keys do while the morph is open. */
import { curved } from "#document/curve/curve";
import { selection } from "#document/morph";
import { pause, play, playing } from "#document/playback";
import { edit, scene } from "#document/scene";
import { fitCommand } from "#stage/commands";
import { type Command, everywhere } from "#ui/commands";
import { type Timeline, timeCommands } from "#ui/strip/timeline";
import type { Colouring } from "#wasm/api";
import { gallery } from "./dialogs";
import { frames } from "./strip/FilmStrip";
import { scrubTo } from "./strip/scrub";

/** The moment of the next frame of the film, in a direction; the end where there is none. */
export function nextFrame(moments: readonly number[], t: number, by: 1 | -1): number {
  const sorted = [...moments].sort((x, y) => x - y);
  const ahead = by > 0 ? sorted.find((x) => x > t + 1e-6) : sorted.findLast((x) => x < t - 1e-6);
  return ahead ?? (by > 0 ? 1 : 0);
}

const TIME: Timeline = {
  now: () => scene.peek().t,
  length: () => 1,
  seek: scrubTo,
  toggle: () => (playing.peek() ? pause() : play()),
  step(by) {
    const moments = frames.peek().map((frame) => frame.t);
    scrubTo(nextFrame(moments, scene.peek().t, by));
  },
  stop: "frame",
};

const COLOURS: readonly Colouring[] = ["map", "address", "density"];
const POINT = "Path, with a point in focus";
const MAP = "Map, in focus";
const SHAPES = "Shapes and picture";

export const commands: readonly Command[] = [
  ...timeCommands(TIME),
  {
    id: "way-move",
    label: "Move by 0.01; Shift finer, Alt coarser",
    group: POINT,
    keys: ["←", "→", "↑", "↓"],
  },
  { id: "way-add", label: "Add a way point", group: POINT, keys: ["+", "Enter"] },
  { id: "way-remove", label: "Remove the way point", group: POINT, keys: ["Delete", "−"] },
  {
    id: "cross-move",
    label: "Move the cross; Shift finer, Alt farther",
    group: MAP,
    keys: ["←", "→", "↑", "↓"],
  },
  { id: "map-zoom", label: "Nearer, farther, all of it", group: MAP, keys: ["+", "−", "0"] },
  { id: "cross-show", label: "Show the shape under the cross", group: MAP, keys: ["Enter"] },
  { id: "cross-way", label: "Make it a way point", group: MAP, keys: ["A"] },
  {
    id: "gallery",
    label: "Gallery",
    group: SHAPES,
    keys: ["G"],
    run: () => {
      gallery.value = selection.peek()?.target ?? "a";
    },
  },
  {
    id: "edit",
    label: "Edit the maps",
    group: SHAPES,
    keys: ["E"],
    // A closed curve is edited where it is fitted.
    enabled: () => !curved.peek(),
    run: () => {
      selection.value = selection.peek() === null ? { target: "a", map: 0 } : null;
    },
  },
  { ...fitCommand(), group: SHAPES },
  {
    id: "colour",
    label: "Colour by map, address, density",
    group: SHAPES,
    keys: ["1", "2", "3"],
    run(way) {
      const colouring = COLOURS[way] ?? "map";
      edit((before) => (before.colouring === colouring ? before : { ...before, colouring }));
    },
  },
  ...everywhere(),
];
