/** Which part of the plane has to be seen, so that the shape has room at every moment. */
import { computed, type ReadonlySignal } from "@preact/signals";
import {
  type Box,
  calmTrack,
  imageOf,
  shortBeside,
  stillTrack,
  type Track,
  UNIT,
  union,
} from "#geometry/boxes";
import { uvAt } from "#geometry/path";
import type { Deformation, MapRow } from "#wasm/api";
import { boxOf } from "./bounds";
import { curveBoxAt, curveMorph } from "./curve/curve";
import { aspect, mapsOfRectangle } from "./deform/photograph";
import { editFrame } from "./editing/frame";
import { type Taken, takenOf } from "./editing/whole";
import {
  held,
  locusView,
  mapsAt,
  morphOptions,
  pairing,
  pathPoints,
  selection,
  shown,
  standing,
} from "./morph";
import { scene } from "./scene";
import { directedBoxAt, standIn } from "./stand-in";

export { type Box, diagonal } from "#geometry/boxes";
export { boxOf } from "./bounds";

/** How often the path is looked at. */
const LOOKS = 13;

/** The box at a moment of what stands in place of the systems; null where nothing does. */
const standInBoxAt = computed(() => {
  const curve = curveMorph.value;
  return curve ? (t: number) => curveBoxAt(curve, t) : directedBoxAt.value;
});

/** The boxes of the morph along the path: the camera follows them, so that each shape is as large as it can be. */
export const pathTrack: ReadonlySignal<Track> = computed(() => {
  const at = standInBoxAt.value;
  if (at) return calmTrack(Array.from({ length: LOOKS }, (_, i) => at(i / (LOOKS - 1))));
  const points = pathPoints.value;
  const options = morphOptions.value;
  return calmTrack(
    Array.from({ length: LOOKS }, (_, i) => boxOf(mapsAt(uvAt(points, i / (LOOKS - 1)), options))),
  );
});

/** Both ends together: what a zoom is measured by, whatever the moment and the path. */
export const pairBox: ReadonlySignal<Box> = computed(() => {
  const at = standInBoxAt.value;
  const boxes = at ? [at(0), at(1)] : [pairing.value.from, pairing.value.to].map(boxOf);
  return union(boxes.filter((box) => box !== null));
});

/** The box of what tools work on: what stands in place of the systems, or the system. */
const standingBox: ReadonlySignal<Box | null> = computed(() => {
  const at = standInBoxAt.value;
  return at ? at(scene.value.t) : boxOf(standing.value);
});

/** Whether the picture is off the path, or not of this morph at all. */
const elsewhere = computed(
  () => !standIn.value && (locusView.value.at !== undefined || locusView.value.family === "polygon"),
);

/** The box of the shape at a waypoint that is being moved: that may lie far from what the path shows. */
export const heldBox: ReadonlySignal<Box | null> = computed(() => held.value && boxOf(shown.value));

/** How much larger than the shape a mesh around it is, on each side. */
const MARGIN = 0.05;

/** Where a mesh belongs around a shape: around its box, which is never without an area, in round numbers. */
export function boxAround(shape: MapRow[] | Box): Deformation["box"] {
  const box = (Array.isArray(shape) ? boxOf(shape) : shape) ?? { x0: 0, y0: 0, x1: 1, y1: 1 };
  const size = Math.max(box.x1 - box.x0, box.y1 - box.y0, 1e-9);
  const [x, y] = [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2];
  const half = (extent: number) => (MARGIN + 0.5) * Math.max(extent, 0.25 * size);
  const [across, up] = [half(box.x1 - box.x0), half(box.y1 - box.y0)];
  const round = shortBeside(size);
  return [round(x - across), round(y - up), round(x + across), round(y + up)];
}

/** Where the mesh belongs around what stands there. */
export const aroundStanding: ReadonlySignal<Deformation["box"]> = computed(() =>
  boxAround(standingBox.value ?? []),
);

// Parts of the document, so that nothing is computed again while its moments go by.
const opened = computed(() => scene.value.tool);
const pictured = computed(() => scene.value.deform?.subject === "picture");
const parts = computed(() => scene.value.deform?.parts ?? 2);
const restBox = computed(() => scene.value.deform?.box);
const columns = computed(() => scene.value.deform?.columns ?? 4);
const keys = computed(() => scene.value.deform?.keys);

/** What is bent, at rest. */
const atRest = computed(() =>
  pictured.value ? boxOf(mapsOfRectangle(aspect.value, parts.value)) : standingBox.value,
);

/** The mesh at rest, where the tool that shows it is open. */
const meshBox: ReadonlySignal<Box | null> = computed(() => {
  if (opened.value !== "deform") return null;
  const [x0, y0, x1, y1] = restBox.value ?? aroundStanding.value;
  return { x0, y0, x1, y1 };
});

/** How far beyond the mesh at rest handles are followed, in its own size: farther ones may leave the stage. */
const FOLLOWED = 0.5;

/** What the deformation tool fits: the shape at rest, and the handles wherever they are in the course of time. */
const bentBox: ReadonlySignal<Box | null> = computed(() => {
  const mesh = meshBox.value;
  if (!mesh) return null;
  const box = union([atRest.value ?? mesh, mesh]);
  const moves = keys.value?.flatMap((key) => key.moves) ?? [];
  const across = mesh.x1 - mesh.x0;
  const up = mesh.y1 - mesh.y0;
  const count = columns.value;
  const rows = Math.max(2, (keys.value?.[0]?.moves.length ?? 0) / 2 / count);
  const far = { ...box };
  for (let i = 0; 2 * i + 1 < moves.length; i++) {
    const point = i % (count * rows);
    const x = mesh.x0 + (across * (point % count)) / (count - 1) + (moves[2 * i] ?? 0);
    const y = mesh.y0 + (up * Math.floor(point / count)) / (rows - 1) + (moves[2 * i + 1] ?? 0);
    far.x0 = Math.min(far.x0, x);
    far.y0 = Math.min(far.y0, y);
    far.x1 = Math.max(far.x1, x);
    far.y1 = Math.max(far.y1, y);
  }
  return {
    x0: Math.max(far.x0, box.x0 - FOLLOWED * across),
    y0: Math.max(far.y0, box.y0 - FOLLOWED * up),
    x1: Math.min(far.x1, box.x1 + FOLLOWED * across),
    y1: Math.min(far.y1, box.y1 + FOLLOWED * up),
  };
});

/** What the stage fits: the morph, the shape that is being edited, or what was picked off the path. */
export const stageTrack: ReadonlySignal<Track> = computed(() => {
  const bent = bentBox.value;
  if (bent) return stillTrack(bent, LOOKS);
  const editing = selection.value;
  if (editing?.whole) return stillTrack(takenTrack(takenOf(scene.value[editing.target])), LOOKS);
  if (editing) return stillTrack(editFrame.value?.seen ?? pairBox.value, LOOKS);
  return elsewhere.value ? stillTrack(boxOf(shown.value) ?? pairBox.value, LOOKS) : pathTrack.value;
});

/** How narrow the box of a shape in hand may be, in proportion: of what is flat nothing could be taken hold of. */
const NARROWEST = 0.1;

/** The box of a shape as it was taken in hand; its image is where the shape is now. */
export function boxOfTaken({ made }: Taken): Box {
  const { x0, y0, x1, y1 } = boxOf(made.maps) ?? UNIT;
  const least = Math.max(NARROWEST * Math.max(x1 - x0, y1 - y0), 1e-9) / 2;
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  return {
    x0: Math.min(x0, x - least),
    y0: Math.min(y0, y - least),
    x1: Math.max(x1, x + least),
    y1: Math.max(y1, y + least),
  };
}

/** Where the shape in hand was and where it is: it is seen to move. */
function takenTrack(taken: Taken): Box {
  const box = boxOfTaken(taken);
  return union([box, imageOf(box, taken.moved)]);
}

/** What stays free round a fitted box, in pixels of the picture. */
interface Insets {
  top: number;
  right: number;
  bottom: number;
  left: number;
}

/** The view that shows a box in the middle of what the insets leave of a picture. A number is a part of each side. */
export function fitFor(
  box: Box,
  size: { width: number; height: number },
  insets: Insets | number,
): { x: number; y: number; scale: number } {
  // A shape that is a point still gets a picture, and a picture that is all insets a scale.
  const across = Math.max(box.x1 - box.x0, 1e-9);
  const up = Math.max(box.y1 - box.y0, 1e-9);
  const { top, right, bottom, left } = typeof insets === "number" ? even(insets, size) : insets;
  const width = Math.max(size.width - left - right, 0.1 * size.width);
  const height = Math.max(size.height - top - bottom, 0.1 * size.height);
  const scale = Math.max(Math.min(width / across, height / up), 1e-6);
  return {
    x: (box.x0 + box.x1) / 2 + (right - left) / 2 / scale,
    y: (box.y0 + box.y1) / 2 + (top - bottom) / 2 / scale,
    scale,
  };
}

function even(part: number, { width, height }: { width: number; height: number }): Insets {
  return { top: part * height, right: part * width, bottom: part * height, left: part * width };
}
