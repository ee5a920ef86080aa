/** Space: what there is, how it moves, and where it is seen from. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type {
  MapRow3,
  Scene,
  Space,
  SpaceFrame,
  SpaceObject,
  SpacePart,
  SpaceTimeline,
  SpaceView,
} from "#wasm/api";
import { loadSpace, type SpaceMotionHandle, solid } from "#wasm/space";
import * as messages from "../messages";
import { notify, wordsOf } from "../notice";
import { spacePlaying } from "../playback";
import { edit, replace, scene } from "../scene";

const NOTHING: SpacePart = { packed: "", at: 0 };
const ready = signal(false);

/** Whether `solid` can be used, and `space` is there. */
export const spaceReady: ReadonlySignal<boolean> = ready;

/** Fetches what computes space. */
export async function openSpace(): Promise<void> {
  await loadSpace();
  ready.value = true;
}

/** What the document says of space. */
export const spacePart: ReadonlySignal<SpacePart> = computed(() => scene.value.space ?? NOTHING);

/** The text that was read or written last, and what it stands for: an edit is not read back. */
let known: { packed: string; space: Space } | null = null;

/** What there is; null until `openSpace` has resolved. */
export const space: ReadonlySignal<Space | null> = computed(() => {
  const { packed } = spacePart.value;
  if (!ready.value) return null;
  if (known?.packed === packed) return known.space;
  let found: Space;
  try {
    found = packed === "" ? solid.defaultSpace() : solid.unpackSpace(packed);
  } catch (problem) {
    notify({ kind: "error", text: messages.showsDefaultSpace(wordsOf(problem)) });
    found = solid.defaultSpace();
  }
  known = { packed, space: found };
  return found;
});

/**
 * One undo step, or a part of one (see `edit`). A change that returns the space it was given does nothing; one that
 * cannot be written into a link throws, and nothing changes.
 */
export function editSpace(
  change: (space: Space) => Space,
  options: { gesture?: string; own?: boolean } = {},
): void {
  const before = space.peek();
  if (!before) return;
  const after = change(before);
  if (after === before) return;
  const packed = solid.packSpace(after);
  // What could be played before is not given up for what cannot.
  if (motion.peek() && (after.timeline || after.morph)) new solid.SpaceMotion(after).free();
  known = { packed, space: after };
  edit((now) => {
    const { own, ...part } = now.space ?? NOTHING;
    const looking = options.own ?? own;
    return { ...now, space: { ...part, packed, ...(looking ? { own: true } : {}) } };
  }, options);
}

/** Where it is seen from when nobody has turned it. */
const plainView: ReadonlySignal<SpaceView | null> = computed(() =>
  space.value ? solid.defaultView(space.value) : null,
);

/** Whether somebody looks around, away from the view that the time line asks for. */
export const lookingAround: ReadonlySignal<boolean> = computed(() => spacePart.value.own === true);

/** Where it is seen from. */
export const spaceView: ReadonlySignal<SpaceView | null> = computed(() => {
  const flown = lookingAround.value ? undefined : spaceFrame.value?.view;
  return flown ?? spacePart.value.view ?? plainView.value;
});

/**
 * Looks from there; null: from where all is seen. To look is nothing to undo. False where nobody can look from there.
 */
export function setView(view: SpaceView | null): boolean {
  if (view && !isView(view)) return false;
  const own = view !== null && spaceFrame.peek()?.view !== undefined;
  // A flight would take the view back at once.
  if (own) spacePlaying.value = false;
  change(({ view: _, own: __, ...rest }) => ({
    ...rest,
    ...(view ? { view } : {}),
    ...(own ? { own: true } : {}),
  }));
  return true;
}

/** Whether a picture can be taken from there. */
function isView({ target, distance, turn, tilt, angle }: SpaceView): boolean {
  const held = [...target, distance, turn, tilt].every((x) => Number.isFinite(x) && Math.abs(x) <= 1e100);
  return held && distance > 0 && angle > 0 && angle < Math.PI;
}

/** From now on the view stays where it is, whatever is done to what is seen. */
export function keepView(): void {
  const view = spaceView.peek();
  if (view && !spacePart.peek().view) change((part) => ({ ...part, view }));
}

/** The moment of the time line, in seconds. */
export const moment: ReadonlySignal<number> = computed(() => spacePart.value.at);

/** Goes to a moment. Nothing to undo. */
export function setMoment(at: number): void {
  const { at: before, own } = spacePart.peek();
  if (at === before && !own) return;
  change(({ own: _, ...part }) => ({ ...part, at }));
}

function change(change: (part: SpacePart) => SpacePart): void {
  const now: Scene = scene.peek();
  replace({ ...now, space: change(now.space ?? NOTHING) });
}

export { spacePlaying };

/** The time line, where there are keys. */
export const timeline: ReadonlySignal<SpaceTimeline | null> = computed(() => {
  const line = space.value?.timeline;
  return line && line.keys.length > 0 ? line : null;
});

/** Why the time line, or the moment, cannot be shown, in words; the last moment that could is shown meanwhile. */
export const motionProblem = signal<string | null>(null);

/** What plays it. The last one is gone when there is another. */
let held: SpaceMotionHandle | null = null;
const motion: ReadonlySignal<SpaceMotionHandle | null> = computed(() => {
  const now = space.value;
  held?.free();
  held = null;
  if (!now) return null;
  try {
    held = new solid.SpaceMotion(now);
    return held;
  } catch (problem) {
    queueMicrotask(() => {
      motionProblem.value = wordsOf(problem);
    });
    return null;
  }
});

let last: SpaceFrame | null = null;

/** All that is now: what the stage shows. null until there is something. */
export const spaceFrame: ReadonlySignal<SpaceFrame | null> = computed(() => {
  const playing = motion.value;
  const at = moment.value;
  // What cannot be played is shown as it was made.
  if (!playing) {
    const now = space.value;
    if (now) last = { objects: now.objects.map(unplayed) };
    return last;
  }
  try {
    last = playing.at(at);
    queueMicrotask(() => {
      motionProblem.value = null;
    });
  } catch (problem) {
    queueMicrotask(() => {
      motionProblem.value = wordsOf(problem);
    });
  }
  return last;
});

function unplayed({ maps, moved = IDENTITY }: SpaceObject): SpaceFrame["objects"][number] {
  try {
    return { maps, moved, now: solid.conjugate3(maps, moved) };
  } catch {
    return { maps, moved, now: maps };
  }
}

/** The object that hands and tables are about. */
const picked = signal(0);
export const chosen: ReadonlySignal<number> = computed(() =>
  Math.min(picked.value, Math.max(0, (space.value?.objects.length ?? 1) - 1)),
);
export function choose(index: number): void {
  picked.value = index;
}

/** What a drag on the stage does: turn the view, or the chosen object by its parameters. */
export const hand = signal<"look" | "turn" | "move" | "scale">("look");

export const IDENTITY: MapRow3 = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];
