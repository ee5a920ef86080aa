/** What there is to see in space at the moment, made ready to be drawn. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { dark, theme } from "#document/preferences";
import { keepBackground } from "#document/space/edits";
import { chosen, space, spaceFrame } from "#document/space/space";
import { apply3 } from "#geometry/maps/affine3";
import { PAPER } from "#style/colours";
import { isDark } from "#style/ground";
import { palette } from "#style/palette";
import type { MapRow3, Point3 } from "#wasm/api";
import { type SpacePictureHandle, solid } from "#wasm/space";
import type { Shown } from "#workers/space/complete-picture";
import { shownObject } from "#workers/space/shown";
import { groundOf } from "../light/light";
import type { Ball } from "./camera";

/** So many points at random. */
const RANDOM = 400;
/** So many steps lead to where a map keeps still, as near as a picture shows. */
const STEPS = 64;

/**
 * Points of an attractor that stand for all of it in a picture. Points at random miss its corners, which often are
 * where a map, or a map after another, keeps still: these are among them.
 */
export function standFor(maps: readonly MapRow3[]): Point3[] {
  const { positions } = solid.attractor3([...maps], { points: RANDOM, seed: 1 });
  const random = Array.from(
    { length: positions.length / 3 },
    (_, i): Point3 => [positions[3 * i] ?? 0, positions[3 * i + 1] ?? 0, positions[3 * i + 2] ?? 0],
  );
  const [start] = random;
  if (!start) return [];
  // All of these are points of the attractor, however slowly a map contracts.
  const still = maps.map((map) =>
    Array.from({ length: STEPS }).reduce((at: Point3) => apply3(map, at), start),
  );
  return [...random, ...still, ...maps.flatMap((map) => still.map((at) => apply3(map, at)))];
}

export interface Sight {
  objects: Shown[];
  handle: SpacePictureHandle;
  ball: Ball;
}

let last: { key: string; objects: Shown[] } | null = null;

/** The objects as they are now: another list only where one of them is another. */
const objects: ReadonlySignal<Shown[] | null> = computed(() => {
  const frame = spaceFrame.value;
  const now = space.value;
  if (!frame || !now) return null;
  const list = frame.objects.map((at, i): Shown => shownObject(at, now.objects[i]));
  const key = JSON.stringify(list);
  if (last?.key !== key) last = { key, objects: list };
  return last.objects;
});

let held: Sight | null = null;

/** null until there is something; what cannot be drawn leaves what was there before. */
export const sight: ReadonlySignal<Sight | null> = computed(() => {
  const list = objects.value;
  if (!list || held?.objects === list) return held;
  try {
    const before = held;
    const handle = before ? before.handle.next(list) : new solid.SpacePicture(list);
    held = { objects: list, handle, ball: ballOf(handle) };
    // Whoever draws has taken the new one by then.
    if (before) setTimeout(() => before.handle.free());
  } catch {
    // The time line says in words why there is none.
  }
  return held;
});

function ballOf({ centre: [x = 0, y = 0, z = 0], radius }: SpacePictureHandle): Ball {
  return { centre: [x, y, z], radius };
}

/** Points of all that is to be seen: the ball around it says little of what is flat or far apart. */
export function samples(): Point3[] {
  const { objects: list = [], ball } = sight.peek() ?? {};
  const points = list.flatMap(({ maps }) => standFor(maps));
  // Of what is bent, only a ball is known.
  if (!ball || !list.some(({ bent }) => bent)) return points;
  const [x, y, z] = ball.centre;
  const r = ball.radius;
  const around: Point3[] = [
    [x + r, y, z],
    [x - r, y, z],
    [x, y + r, z],
    [x, y - r, z],
    [x, y, z + r],
    [x, y, z - r],
  ];
  return [...points, ...around];
}

let known: { key: string; ball: Ball } | null = null;

/**
 * A ball around the chosen object. It is that of the shape as made, moved along: so it stays where it is while the
 * object turns about its middle.
 */
export function chosenBall(): Ball | null {
  const object = spaceFrame.peek()?.objects[chosen.peek()];
  if (!object) return null;
  const key = JSON.stringify(object.maps);
  if (known?.key !== key) {
    const handle = new solid.SpacePicture([{ maps: object.maps }]);
    known = { key, ball: ballOf(handle) };
    handle.free();
  }
  const [a, b, c, d, e, f, g, h, i] = object.moved;
  const stretch = Math.max(Math.hypot(a, d, g), Math.hypot(b, e, h), Math.hypot(c, f, i));
  return { centre: apply3(object.moved, known.ball.centre), radius: known.ball.radius * stretch };
}

const stageColour = signal(PAPER);

/** The colour under the picture, "#rrggbb": what fog fades into. */
export const ground: ReadonlySignal<string> = computed(() =>
  groundOf(space.value?.background, stageColour.value),
);

/** One colour a map, as the stage of the plane has them: those that stand out from the ground. */
export const colours: ReadonlySignal<string[]> = computed(() =>
  palette(isDark(ground.value) ? "dark" : "light"),
);

/** Keeps `ground` up with the document and the theme. Returns the end of it. */
export function watchGround(): () => void {
  let frame = 0;
  const read = () => {
    const found = getComputedStyle(document.documentElement).getPropertyValue("--stage").trim();
    if (/^#[0-9a-f]{6}$/i.test(found)) stageColour.value = found;
  };
  read();
  // From now on the picture looks as it does here, whoever opens it.
  const stopKeeping = effect(() => {
    const now = space.value;
    if (now && now.background === undefined) queueMicrotask(() => keepBackground(stageColour.peek()));
  });
  const stop = effect(() => {
    dark.value;
    theme.value;
    // The style sheet follows the choice of a theme: by the next frame it has.
    cancelAnimationFrame(frame);
    frame = requestAnimationFrame(read);
  });
  return () => {
    stopKeeping();
    stop();
    cancelAnimationFrame(frame);
  };
}
