/** What keys do while the morph is open. */
import { here, locusView, selection } from "#document/morph";
import { announce } from "#document/notice";
import { pause, play, playing } from "#document/playback";
import { edit, scene } from "#document/scene";
import { standIn } from "#document/stand-in";
import { colourCommand, fitCommand, galleryCommand } from "#stage/commands";
import { type Command, everywhere, widgetKeys } from "#ui/commands";
import { exportCommand } from "#ui/files/exporting";
import type { Timeline } from "#ui/strip/timeline";
import { editMaps, endEditing, gallery, takeWhole, toggleOrbit } from "./dialogs";
import { course, placeOf } from "./locus/families/course";
import { toggleFull, toggleLarge } from "./locus/view/large";
import { frames } from "./strip/FilmStrip";
import { scrubTo } from "./strip/scrub";

/** The moment of the next frame of the film, in a direction; the end where there is none. */
export function nextFrame(moments: readonly number[], t: number, by: 1 | -1): number {
  const sorted = [...moments].sort((x, y) => x - y);
  const ahead = by > 0 ? sorted.find((x) => x > t + 1e-6) : sorted.findLast((x) => x < t - 1e-6);
  return ahead ?? (by > 0 ? 1 : 0);
}

/** Whether the map is another family's, which moves by its own parameter. */
const elsewhere = () => locusView.peek().family === "polygon" && !standIn.peek();
const orbit = () => import("./locus/families/orbit");

export const timeline: Timeline = {
  now: () => (elsewhere() ? placeOf(here.peek(), course.peek()) : scene.peek().t),
  length: () => 1,
  seek(moment) {
    if (elsewhere()) void orbit().then(({ orbitTo }) => orbitTo(moment));
    else scrubTo(moment);
  },
  toggle() {
    if (elsewhere()) void orbit().then(({ toggleOrbit }) => toggleOrbit());
    else if (playing.peek()) pause();
    else play();
  },
  step(by) {
    if (elsewhere()) return void orbit().then(({ orbitTo, place }) => orbitTo(place.peek() + by / 24));
    const moments = frames.peek().map((frame) => frame.t);
    scrubTo(nextFrame(moments, scene.peek().t, by));
  },
  stop: "frame",
};

const SHAPES = "Shapes and picture";

/** Whether the focus is on the picture, or nowhere. */
const onStage = () =>
  !document.activeElement?.matches("body *") || !!document.activeElement.closest(".stage");

export const commands: readonly Command[] = [
  ...widgetKeys("Path, with a point in focus", [
    ["way-move", "Move by 0.01; Shift finer, Alt coarser", "←", "→", "↑", "↓"],
    ["way-add", "Add a waypoint", "+", "Enter"],
    ["way-remove", "Remove the waypoint", "Delete", "−"],
  ]),
  ...widgetKeys("Outline of a map, in focus (Tab)", [
    ["map-move", "Choose it and move it; Shift finer", "←", "→", "↑", "↓"],
    ["map-choose", "Choose it", "Enter"],
  ]),
  ...widgetKeys("Map, in focus", [
    ["cross-move", "Move the cross; Shift finer, Alt farther", "←", "→", "↑", "↓"],
    ["map-zoom", "Nearer, farther, all of it", "+", "−", "0"],
    ["cross-show", "Show the shape under the cross", "Enter"],
    ["cross-way", "Make it a waypoint", "A"],
  ]),
  ...widgetKeys("A point that is followed", [
    ["orbit-map", "Apply the map of this number", "1", "…", "9"],
    ["orbit-back", "One step back", "Backspace"],
    ["orbit-move", "Move the point, in focus; Shift finer", "←", "→", "↑", "↓"],
  ]),
  galleryCommand(SHAPES, () => {
    gallery.value = selection.peek()?.target ?? "a";
  }),
  {
    id: "edit",
    label: "Edit the maps",
    group: SHAPES,
    keys: ["E"],
    // A closed curve is edited where it is fitted, a graph in its panel.
    enabled: () => !standIn.peek(),
    run: () => {
      if (selection.peek() === null) editMaps("a");
      else endEditing();
    },
  },
  {
    id: "whole",
    label: "Take the whole shape in hand",
    group: SHAPES,
    keys: ["Shift+E"],
    enabled: () => !standIn.peek(),
    run() {
      const now = selection.peek();
      if (now?.whole) endEditing();
      else takeWhole(now?.target ?? "a");
    },
  },
  {
    id: "map-remove",
    label: "Remove the map that is chosen",
    group: SHAPES,
    keys: ["Delete", "Backspace"],
    // Whoever is elsewhere on the page means something else by this key.
    enabled: () => selection.peek()?.map != null && !selection.peek()?.whole && onStage(),
    run: () => void import("./maps/remove").then(({ removeChosen }) => removeChosen()),
  },
  {
    id: "map-large",
    label: "The map in the place of the stage, and back",
    group: SHAPES,
    keys: ["L"],
    enabled: () => !standIn.peek(),
    run: toggleLarge,
  },
  {
    id: "map-full",
    label: "The map over the whole screen, and back",
    group: SHAPES,
    keys: ["Shift+L"],
    enabled: () => !standIn.peek(),
    run: () => void toggleFull(),
  },
  {
    id: "orbit",
    label: "Follow a point, map by map, and end it",
    group: SHAPES,
    keys: ["Shift+O"],
    enabled: () => !standIn.peek(),
    run: toggleOrbit,
  },
  { ...fitCommand(), group: SHAPES },
  colourCommand(["map", "address", "density"], SHAPES, (colouring) =>
    edit((before) => (before.colouring === colouring ? before : { ...before, colouring })),
  ),
  {
    id: "describe",
    label: "Say what the picture looks like",
    group: SHAPES,
    keys: ["D"],
    run: () =>
      void import("./evidence/describe").then(async ({ describeStage }) => announce(await describeStage())),
  },
  // What stands in their place is no system to write.
  exportCommand(() => !standIn.peek()),
  ...everywhere(),
];
