/** What follows from the document for the morph: the pair, the path, the present moment, and the maps there. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { sameMaps } from "#geometry/maps/same-maps";
import { pointsOf, type Uv, uvAt } from "#geometry/path";
import type { Ifs, LocusView, MapRow, MorphOptions, Pairing } from "#wasm/api";
import { frond } from "#wasm/core";
import { pieceColours, ranked } from "./colours";
import { inGesture, scene } from "./scene";
import { standIn } from "./stand-in";

export { uvAt } from "#geometry/path";

/** What is edited: the maps of one end, or, taken in hand, the whole shape. The stage shows that shape alone. */
interface Selection {
  target: "a" | "b";
  map: number | null;
  whole?: boolean;
}

/** Editing one end: the stage shows that shape and its parallelograms. */
export const selection = signal<Selection | null>(null);

// Parts of the scene, so that what hangs on a part is not computed again when only the moment has changed.
const a = computed(() => scene.value.a.maps);
const b = computed(() => scene.value.b.maps);
const mode = computed(() => scene.value.mode);
const path = computed(() => scene.value.path);
const correspondence = computed(() => scene.value.correspondence);
const turns = computed(() => scene.value.turns);
// While the moments of what stands in their place go by, the systems stand still, and nothing has to be known of them.
const t = computed(() => (standIn.value ? 0 : scene.value.t));

let lastPairing: Pairing | null = null;

/** Both ends with the same number of maps. A pair that cannot be made leaves the last good one. */
export const pairing: ReadonlySignal<Pairing> = computed(() => {
  const from = a.value;
  const to = b.value;
  try {
    lastPairing = frond.pair({ maps: from }, { maps: to });
  } catch {
    const count = Math.min(from.length, to.length);
    lastPairing ??= { from: from.slice(0, count), to: to.slice(0, count), steps: [] };
  }
  return lastPairing;
});

/**
 * The place of each of an end's own maps among `paired`, the maps that it has in the morph: its colour goes by it, on
 * the stage as everywhere. In their own order where they are not what is paired: pieces that were split have no map.
 */
export function ranksIn(
  own: readonly MapRow[],
  paired: readonly MapRow[],
  order?: readonly number[],
): number[] {
  const shown = order?.map((index) => paired[index]) ?? paired;
  const covered = new Set<number>();
  const ranks: number[] = [];
  for (const map of own) {
    // Of a map that was doubled all places are its own.
    const places = shown.flatMap((other, i) => (other && sameMaps([map], [other]) ? [i] : []));
    for (const place of places) covered.add(place);
    ranks.push(places.find((i) => !ranks.includes(i)) ?? places[0] ?? -1);
  }
  return ranks.includes(-1) || covered.size < shown.length ? own.map((_, i) => i) : ranks;
}

/** The same list for as long as it says the same. */
function ranksOf(end: "a" | "b"): ReadonlySignal<readonly number[]> {
  let last: number[] = [];
  return computed(() => {
    const { from, to } = pairing.value;
    const { correspondence } = morphOptions.value;
    const next = end === "a" ? ranksIn(a.value, from) : ranksIn(b.value, to, correspondence);
    if (next.join() !== last.join()) last = next;
    return last;
  });
}

/** Everything besides (u, v) that the morph hangs on. Lists of the wrong length count as the default. */
export const morphOptions: ReadonlySignal<MorphOptions> = computed(() => {
  const count = pairing.value.from.length;
  const options: MorphOptions = { mode: mode.value };
  if (correspondence.value.length === count) options.correspondence = correspondence.value;
  if (turns.value.length === count) options.turns = turns.value;
  return options;
});

export const ranks = { a: ranksOf("a"), b: ranksOf("b") };

/** For each map that turns by half a turn, the whole turns that make it the other half turn; 0 for all others. */
export const halfTurns: ReadonlySignal<number[]> = computed(() => {
  const { from, to } = pairing.value;
  try {
    return frond.halfTurns({ maps: from }, { maps: to }, morphOptions.value);
  } catch {
    return [];
  }
});

/** The path from (0,0) to (1,1), both included. */
export const pathPoints: ReadonlySignal<Uv[]> = computed(() => pointsOf(path.value));

/** The point of the path at the present moment. */
export const uv: ReadonlySignal<Uv> = computed(() => uvAt(pathPoints.value, t.value));

/** The maps at any parameter; the first shape's where the morph is not defined. */
export function mapsAt(at: Uv, options: MorphOptions = morphOptions.value): MapRow[] {
  return mapsBetween(pairing.value, at, options);
}

/** The same of a pair that is given, whatever the document has become. */
export function mapsBetween({ from, to }: Pairing, [u, v, w = 0]: Uv, options: MorphOptions): MapRow[] {
  const ends: [Ifs, Ifs] = [{ maps: from }, { maps: to }];
  try {
    return frond.interpolate(...ends, { ...options, u, v, w }).maps;
  } catch {
    return from;
  }
}

/** The maps at the present moment. */
export const current: ReadonlySignal<MapRow[]> = computed(() => mapsAt(uv.value));

/**
 * What other tools work on: an end with the maps that it has by itself, whose number is that of its pieces, or the
 * morph on its way between both, for which they may have been refined.
 */
export const standing: ReadonlySignal<MapRow[]> = computed(() => {
  if (t.value === 0) return a.value;
  return t.value === 1 ? b.value : current.value;
});

const morphing = computed(() => (scene.value.tool ?? "morph") === "morph");

/** How the locus is looked at where the document does not say: all of the plane w = 0. */
export const WHOLE: LocusView = { family: "morph", sides: 2, x: 0.5, y: 0.5, zoom: 1, w: 0 };

export const locusView: ReadonlySignal<LocusView> = computed(() => scene.value.locus ?? WHOLE);

const off = computed(() => locusView.value.at);
/** The number of corners where the map is that of a polygon family. */
const sides = computed(() => (locusView.value.family === "polygon" ? locusView.value.sides : null));

/** Where a polygon family starts: well inside, and all in one piece for any number of sides. */
export const FIRST_S: Uv = [0.5, 0.5];

const heldPoint = signal<Uv | null>(null);

/** The waypoint that a hand or a key has hold of, for as long as it does: the picture shows what is there. */
export const held: ReadonlySignal<Uv | null> = computed(() => (inGesture.value ? heldPoint.value : null));

/** A waypoint is moved in the gesture that is under way. */
export function hold(point: Uv): void {
  heldPoint.value = point;
}

effect(() => {
  if (!inGesture.value) heldPoint.value = null;
});

/**
 * The parameter that the picture shows: on the path, or that which was picked off it, or where a waypoint is being
 * moved; of a polygon family, s.
 */
export const here: ReadonlySignal<Uv> = computed(
  () => held.value ?? off.value ?? (sides.value === null ? uv.value : FIRST_S),
);

/** The maps that the locus speaks of at `here`. */
const picked: ReadonlySignal<MapRow[]> = computed(() => {
  const [x, y, w = 0] = here.value;
  if (sides.value === null) return held.value || off.value ? mapsAt([x, y, w]) : current.value;
  try {
    return frond.familyMaps({ sides: sides.value }, [x, y]).maps;
  } catch {
    return current.value;
  }
});

/** Whether the stage shows what the map speaks of. */
const mapped = computed(() => morphing.value && !selection.value);

/**
 * The parameter that was picked off the path and is shown, and of which family; null where the stage shows something
 * else.
 */
export const shownPick: ReadonlySignal<{ at: Uv; sides: number | null } | null> = computed(() =>
  mapped.value && (off.value || sides.value !== null) ? { at: here.value, sides: sides.value } : null,
);

/**
 * What the stage shows: the morph, a system of another family, the shape that is being edited, or what a tool works on.
 */
export const shown: ReadonlySignal<MapRow[]> = computed(() => {
  const editing = selection.value;
  if (!morphing.value) return standing.value;
  if (!editing) return picked.value;
  return editing.target === "a" ? a.value : b.value;
});

/**
 * How often the chaos game takes each map that the stage shows, where the document says so. `weights.ts` keeps it, once
 * a document has some: most have none.
 */
export const ownWeights = signal<number[] | undefined>(undefined);

/** The elementwise morph at the same moment, for the comparison. */
export const linear: ReadonlySignal<MapRow[]> = computed(() =>
  mapsAt(uv.value, { ...morphOptions.value, mode: "linear" }),
);

/** The colours of what the stage shows: a shape that is edited has its maps in their own order, each in its colour. */
export function shownColours(theme: "light" | "dark"): string[] {
  const all = pieceColours(theme);
  const editing = selection.value;
  return editing ? ranked(all, ranks[editing.target].value) : all;
}
