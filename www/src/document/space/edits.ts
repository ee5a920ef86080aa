/**
 * Edits of space. With a time line, what is done to an object is remembered at its moment; the view only when that is
 * asked for.
 */
import type { Ease, MapRow3, Space, SpaceFrame, SpaceKey, SpaceObject, SpaceTimeline } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "../messages";
import { notify, wordsOf } from "../notice";
import { edit, replace, scene } from "../scene";
import {
  chosen,
  editSpace,
  IDENTITY,
  keepView,
  moment,
  setMoment,
  setView,
  space,
  spaceFrame,
  spacePart,
  spacePlaying,
  spaceView,
  timeline,
} from "./space";

type Options = { gesture?: string; own?: boolean };

/** Keys within this many seconds are one. */
export const SAME_KEY_S = 0.02;
export const EMPTY_LINE: SpaceTimeline = { seconds: 6, loop: "round", course: "smooth", keys: [] };

/** As `editSpace`, where nobody else says why it could not be done. Whether it was. */
export function changeSpace(change: (space: Space) => Space, options: Options = {}): boolean {
  try {
    editSpace(change, options);
    return true;
  } catch (problem) {
    notify({ kind: "error", text: wordsOf(problem) });
    return false;
  }
}

/** The background of a document that says nothing of it: from now on it does. Nothing to undo. */
export function keepBackground(background: string): void {
  const now = space.peek();
  if (!now || now.background !== undefined) return;
  try {
    const packed = solid.packSpace({ ...now, background });
    replace({ ...scene.peek(), space: { ...spacePart.peek(), packed } });
  } catch {
    // As full as a link can be: it stays as it came.
  }
}

/** As `changeSpace`, for what may take the morph with it: that is told. */
export function reshapeSpace(change: (space: Space) => Space, options: Options = {}): boolean {
  const morphed = space.peek()?.morph !== undefined;
  const done = changeSpace(change, options);
  if (done) tellOfMorph(morphed);
  return done;
}

/** Says that there is no morph any more, where there was one. */
export function tellOfMorph(before: boolean): void {
  if (!before || space.peek()?.morph) return;
  notify({ kind: "info", text: messages.morphEnded });
}

/**
 * Moves the chosen object, by conjugating its parameters. Throws where the transform cannot be undone: nothing changes.
 */
export function moveObject(by: MapRow3, options: Options = {}): void {
  const index = chosen.peek();
  const before = spaceFrame.peek()?.objects[index]?.moved ?? IDENTITY;
  placeObject(solid.compose3(by, before), options);
}

/** Puts the chosen object there: `moved` in one transform; null: where it was made. Throws as `moveObject`. */
export function placeObject(moved: MapRow3 | null, options: Options = {}): void {
  const index = chosen.peek();
  const maps = spaceFrame.peek()?.objects[index]?.maps;
  // What cannot be drawn is refused before anything changes.
  if (maps && moved) solid.conjugate3(maps, moved);
  // Else the view would follow, and nothing be seen of it; and a film that plays would sow keys.
  keepView();
  spacePlaying.value = false;
  if (timeline.peek()) {
    keyNow(
      (key, count) => ({ ...key, moved: withItem(key.moved, count, index, moved ?? IDENTITY) }),
      options,
    );
    return;
  }
  editSpace((now) => changeObject(now, index, (object) => withMoved(object, moved)), options);
}

function withMoved(object: SpaceObject, moved: MapRow3 | null): SpaceObject {
  const { moved: _, ...rest } = object;
  return moved?.some((x, i) => x !== IDENTITY[i]) ? { ...rest, moved } : rest;
}

/** Whether the time line says what maps an object is made with. */
export function hasKeyedMaps(line: SpaceTimeline | null, index: number): boolean {
  return line?.keys.some((key) => key.maps?.[index]) ?? false;
}

/**
 * Other numbers for the maps of the chosen object, as many as there are. With a time line they are those of its moment,
 * and the other keys keep what was. Throws where they have no attractor.
 */
export function changeMaps(maps: MapRow3[], options: Options = {}): void {
  solid.validate3(maps);
  const index = chosen.peek();
  const line = timeline.peek();
  const morphs = index === 0 && space.peek()?.morph !== undefined;
  if (!line || morphs) {
    editSpace(
      (now) => changeObject(now, index, ({ preset: _, ...object }) => ({ ...object, maps })),
      options,
    );
    return;
  }
  spacePlaying.value = false;
  const made = spaceFrame.peek()?.objects[index]?.maps ?? maps;
  const first = !hasKeyedMaps(line, index);
  keyNow(
    (key, count) => ({ ...key, maps: withItem(key.maps, count, index, maps) }),
    options,
    (key, count) => (first ? { ...key, maps: withItem(key.maps, count, index, made) } : key),
  );
}

/** How a scene is to be seen that brings its own light and sky. */
export type Look = Pick<Space, "light" | "background">;

/** Another beginning: these objects alone, with neither morph nor time line; what brings no look has the usual one. */
export function startWith(objects: SpaceObject[], look?: Look): void {
  for (const object of objects) solid.validate3(object.maps);
  edit((now) => {
    const light = look?.light ?? solid.defaultSpace().light;
    const before = space.peek()?.background;
    // A sky leaves with the scene that it came with.
    const kept = before === solid.naturalSpace().background ? undefined : before;
    const background = look?.background ?? kept;
    const first: Space = { objects, light, ...(background === undefined ? {} : { background }) };
    return { ...now, space: { packed: solid.packSpace(first), at: 0 } };
  });
}

function changeObject(now: Space, index: number, change: (object: SpaceObject) => SpaceObject): Space {
  return { ...now, objects: now.objects.map((object, i) => (i === index ? change(object) : object)) };
}

/** Where along the morph it is: remembered at the moment where the time line says so already. */
export function setMorphTime(t: number, options: Options = {}): void {
  spacePlaying.value = false;
  if (timeline.peek()?.keys.some((key) => key.t !== undefined)) {
    keyNow((key) => ({ ...key, t }), options);
    return;
  }
  changeSpace((now) => (now.morph ? { ...now, morph: { ...now.morph, t } } : now), options);
}

/** Where the lattices of all bent objects are now. What a key said of others is no longer so. */
function bendsOf({ objects }: SpaceFrame, before: SpaceKey["bends"]): Pick<SpaceKey, "bends"> {
  const made = space.peek()?.objects ?? [];
  const bends = objects.map(({ bend }, i) => bend ?? made[i]?.bend?.moves ?? null);
  return before || bends.some((moves) => moves !== null) ? { bends } : {};
}

/** A key for all that is now: the view, where each object is, how far the morph is, how lattices are bent. */
export function addKey(ease: Ease = "inout"): void {
  const view = spaceView.peek();
  const frame = spaceFrame.peek();
  if (!view || !frame) return;
  const { holds: _, ...plain } = view;
  keyNow(
    (key) => ({
      ...key,
      ease: key.ease ?? ease,
      view: plain,
      moved: frame.objects.map((object) => object.moved),
      ...bendsOf(frame, key.bends),
      ...(frame.t === undefined ? {} : { t: frame.t }),
    }),
    { own: false },
  );
}

export function changeTimeline(change: (line: SpaceTimeline) => SpaceTimeline, options: Options = {}): void {
  editSpace((now) => {
    const after = change(now.timeline ?? EMPTY_LINE);
    if (after === now.timeline) return now;
    const { timeline: _, ...rest } = now;
    return after.keys.length === 0 && after === EMPTY_LINE ? rest : { ...rest, timeline: after };
  }, options);
}

/** Without a time line: what is seen at the moment stays, and nothing moves any more. */
export function endTimeline(): void {
  const frame = spaceFrame.peek();
  const view = spaceView.peek();
  editSpace((now) => settled(now, frame), { own: false });
  // The next time line begins as long as any.
  setMoment(Math.min(moment.peek(), EMPTY_LINE.seconds));
  // A flight has no last view of its own: what is seen would jump.
  if (frame?.view && view) setView(view);
}

/** Space as it is at a moment, for all time. */
export function settled(now: Space, frame: SpaceFrame | null): Space {
  const { timeline: line, ...rest } = now;
  if (!line || !frame) return rest;
  const objects = now.objects.map((plain, i) => {
    const at = frame.objects[i];
    if (!at) return plain;
    const object = plain.bend && at.bend ? { ...plain, bend: { ...plain.bend, moves: at.bend } } : plain;
    // The maps of what morphs are those of its place on the morph.
    const morphs = i === 0 && now.morph !== undefined;
    if (morphs || !hasKeyedMaps(line, i)) return withMoved(object, at.moved);
    const { preset: _, ...own } = object;
    return withMoved({ ...own, maps: at.maps }, at.moved);
  });
  const morph = now.morph && frame.t !== undefined ? { morph: { ...now.morph, t: frame.t } } : {};
  return { ...rest, objects, ...morph };
}

/** Changes the key at the moment, or puts one there; `others` changes the rest. */
export function keyNow(
  change: (key: SpaceKey, objects: number) => SpaceKey,
  options: Options = {},
  others: (key: SpaceKey, objects: number) => SpaceKey = (key) => key,
): void {
  // What was undone may have left the moment beyond the end.
  const { seconds } = space.peek()?.timeline ?? EMPTY_LINE;
  if (moment.peek() > seconds) setMoment(seconds);
  const at = moment.peek();
  editSpace((now) => {
    const line = now.timeline ?? EMPTY_LINE;
    const before = line.keys.find((key) => Math.abs(key.at - at) < SAME_KEY_S);
    const key = change(before ?? { at, ease: "inout" }, now.objects.length);
    const rest = line.keys.filter((other) => other !== before);
    const keys = [...rest.map((other) => others(other, now.objects.length)), key].sort((a, b) => a.at - b.at);
    return { ...now, timeline: { ...line, keys } };
  }, options);
}

/** A list for all objects, with another entry for one of them. */
export function withItem<T>(
  list: readonly (T | null)[] | undefined,
  count: number,
  index: number,
  item: T,
): (T | null)[] {
  return Array.from({ length: count }, (_, i) => (i === index ? item : (list?.[i] ?? null)));
}
