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
import { scrubTo } from "./edits";
import { course, placeOf } from "./locus/families/course";
import { toggleFull, toggleLarge } from "./locus/view/large";
import * as messages from "./messages";
import { frames } from "./strip/FilmStrip";

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

const SHAPES = messages.shapesAndPicture;

/** Whether the focus is on the picture, or nowhere. */
const onStage = () =>
  !document.activeElement?.matches("body *") || !!document.activeElement.closest(".stage");

export const commands: readonly Command[] = [
  ...widgetKeys(messages.pathWithPointFocused, [
    ["way-move", messages.moveBy001, "←", "→", "↑", "↓"],
    ["way-add", messages.addWaypoint, "+", messages.enter],
    ["way-remove", messages.removeWaypoint, messages.deleteLabel, "−"],
  ]),
  ...widgetKeys(messages.outlineMapFocusedTab, [
    ["map-move", messages.selectAndMoveShift, "←", "→", "↑", "↓"],
    ["map-choose", messages.select, messages.enter],
  ]),
  ...widgetKeys(messages.locusFocused, [
    ["cross-move", messages.moveCrossShiftFiner, "←", "→", "↑", "↓"],
    ["map-zoom", messages.zoomInZoomOut, "+", "−", "0"],
    ["cross-show", messages.showShapeAtCross, messages.enter],
    ["cross-way", messages.makeWaypoint, "A"],
  ]),
  ...widgetKeys(messages.followingPoint, [
    ["orbit-map", messages.applyMapWithThis, "1", "…", "9"],
    ["orbit-back", messages.oneStepBack, messages.backspace],
    ["orbit-move", messages.movePointFocusedShift, "←", "→", "↑", "↓"],
  ]),
  galleryCommand(SHAPES, () => {
    gallery.value = selection.peek()?.target ?? "a";
  }),
  {
    id: "edit",
    label: messages.editMaps,
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
    label: messages.moveOrRotateWhole,
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
    label: messages.removeSelectedMap,
    group: SHAPES,
    keys: ["Delete", "Backspace"],
    // Whoever is elsewhere on the page means something else by this key.
    enabled: () => selection.peek()?.map != null && !selection.peek()?.whole && onStage(),
    run: () => void import("./maps/map-edits").then(({ removeChosen }) => removeChosen()),
  },
  {
    id: "map-large",
    label: messages.swapPictureAndLocus,
    group: SHAPES,
    keys: ["L"],
    enabled: () => !standIn.peek(),
    run: toggleLarge,
  },
  {
    id: "map-full",
    label: messages.locusOnWholeScreen,
    group: SHAPES,
    keys: ["Shift+L"],
    enabled: () => !standIn.peek(),
    run: () => void toggleFull(),
  },
  {
    id: "orbit",
    label: messages.followPointMapBy,
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
    label: messages.describePicture,
    group: SHAPES,
    keys: ["D"],
    run: () =>
      void import("./evidence/describe").then(async ({ describeStage }) => announce(await describeStage())),
  },
  // What stands in their place is no system to write.
  exportCommand(() => !standIn.peek()),
  ...everywhere(),
];
