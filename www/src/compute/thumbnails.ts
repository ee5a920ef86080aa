/** Small pictures of the gallery and of both ends. */
import { computed, effect, untracked } from "@preact/signals";
import { pieceColours, ranked } from "#document/colours";
import { morphOptions, pairing, ranks, selection } from "#document/morph";
import { dark } from "#document/preferences";
import { scene } from "#document/scene";
import { sameMaps } from "#geometry/maps/same-maps";
import { palette } from "#style/palette";
import type { MapRow } from "#wasm/api";
import { frond } from "#wasm/core";
import { Coalesce } from "#workers/pool/coalesce";
import { epoch, submit } from "#workers/pool/engine";
import type { Job } from "#workers/pool/protocol";
import { publish } from "./results";

/** CSS pixels. */
const THUMB_WIDTH = 144;
const THUMB_HEIGHT = 104;

/** What each thumbnail should show, and what is still to do, the ends first. */
const wanted = new Map<string, { maps: MapRow[]; colours: string[] }>();
const todo = new Set<string>();
const queue = new Coalesce(submit);

export function scheduleThumbnails(): void {
  effect(() => {
    epoch.value;
    untracked(() => {
      queue.reset();
      wanted.clear();
    });
  });
  for (const end of ["a", "b"] as const) {
    const own = computed(() => scene.value[end].maps);
    const shown = computed(() => onStage(end, own.value));
    const edited = computed(() => selection.value?.target === end);
    effect(() => {
      const maps = shown.value;
      if (edited.value) ranks[end].value;
      dark.value;
      epoch.value;
      untracked(() => wantEnd(end, maps));
    });
  }
  effect(() => {
    dark.value;
    epoch.value;
    untracked(() => {
      for (const preset of frond.presets()) want(preset.id, preset.maps);
    });
  });
}

/** Has pictures made of shapes that are no part of the document, until the returned function is called. */
export function thumbnailsOf(shapes: readonly { id: string; maps: MapRow[] }[]): () => void {
  const stop = effect(() => {
    dark.value;
    epoch.value;
    untracked(() => {
      for (const { id, maps } of shapes) want(id, maps);
    });
  });
  return () => {
    stop();
    const left = new Map(publish.thumbnails.peek());
    for (const { id } of shapes) {
      for (const list of [wanted, todo, left]) list.delete(id);
    }
    publish.thumbnails.value = left;
  };
}

/** Maps of an end in the order of the morph's, so that each has the colour that it has on the stage. */
function onStage(end: "a" | "b", own: MapRow[]): MapRow[] {
  if (selection.value?.target === end) return own;
  const { from, to } = pairing.value;
  const { correspondence } = morphOptions.value;
  return inOrder(own, end === "a" ? from : to, end === "b" ? correspondence : undefined);
}

/**
 * What `own` are paired as, some of them twice, and in which order; `own` where that is not what they are paired as:
 * pieces that were split have no colour of their own, and a pair that cannot be made leaves the one before it.
 */
export function inOrder(own: MapRow[], paired: MapRow[], order?: readonly number[]): MapRow[] {
  const isThere = (map: MapRow, among: MapRow[]) => among.some((other) => sameMaps([map], [other]));
  const maps = order?.map((index) => paired[index]).filter((map) => map !== undefined) ?? paired;
  if (sameMaps(maps, own)) return own;
  return own.every((map) => isThere(map, maps)) && maps.every((map) => isThere(map, own)) ? maps : own;
}

const names = { a: "", b: "" };

/** Another shape is not shown by the picture of the one before it; while one is changed by hand that stays. */
function wantEnd(end: "a" | "b", maps: MapRow[]): void {
  const { name } = scene.peek()[end];
  const before = wanted.get(end);
  if (name !== names[end] && !(before && sameMaps(before.maps, maps))) {
    const left = new Map(publish.thumbnails.peek());
    if (left.delete(end)) publish.thumbnails.value = left;
  }
  names[end] = name;
  const colours = pieceColours(theme());
  // Whoever edits maps sees them by themselves, each in the colour that it has in the morph.
  want(end, maps, selection.peek()?.target === end ? ranked(colours, ranks[end].peek()) : colours);
}

const sameColours = (p: readonly string[], q: readonly string[]) => p === q || p.join() === q.join();

const theme = () => (dark.peek() ? "dark" : "light");

function want(id: string, maps: MapRow[], colours = palette(theme())): void {
  const before = wanted.get(id);
  // A link that is followed brings both ends anew, though mostly one of them is as it was.
  if (before && sameColours(before.colours, colours) && sameMaps(before.maps, maps)) return;
  wanted.set(id, { maps, colours });
  todo.add(id);
  queue.request(job);
}

function job(): Job<"picture"> {
  const dpr = Math.min(2, globalThis.devicePixelRatio || 1);
  const size = { width: Math.round(THUMB_WIDTH * dpr), height: Math.round(THUMB_HEIGHT * dpr) };
  const asked = new Map<object, { id: string; maps: MapRow[] }>();
  return {
    channel: "thumbnails",
    priority: () => (todo.has("a") || todo.has("b") ? 40 : 10),
    next() {
      const id = ["a", "b"].find((end) => todo.has(end)) ?? todo.values().next().value;
      const what = id === undefined ? undefined : wanted.get(id);
      if (id === undefined || !what) return null;
      todo.delete(id);
      const options = { ...size, colouring: "map" as const, palette: what.colours };
      const task = { kind: "picture" as const, maps: what.maps, options };
      asked.set(task, { id, maps: what.maps });
      return task;
    },
    accept(task, bitmap) {
      const { id, maps } = asked.get(task) ?? {};
      // A later wish for the same id may have been drawn by another worker already.
      if (id === undefined || (wanted.get(id)?.maps !== maps && !todo.has(id))) return;
      publish.thumbnails.value = new Map(publish.thumbnails.peek()).set(id, bitmap);
    },
    // A shape without an attractor keeps the picture it last had.
    fail() {},
  };
}
