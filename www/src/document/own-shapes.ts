/** Shapes that a person keeps, in this browser: the gallery lists them beside its own. */
import { type ReadonlySignal, signal } from "@preact/signals";
import { exactOf, withExact } from "#geometry/maps/exact";
import type { DirectedMap, DirectedShape, MapRow, Shape } from "#wasm/api";
import * as messages from "./messages";

export interface OwnShape {
  id: string;
  name: string;
  maps: MapRow[];
  weights?: number[];
  /** Formulas of numbers that the maps mean exactly. */
  exact?: string[];
  /** Of a graph-directed shape, which has no maps but these. */
  states?: DirectedMap[][];
  /** The closed curve that its states are made of, packed. */
  outline?: string;
}

const KEY = "frond.shapes";
const MOST_SHAPES = 60;
const MOST_MAPS = 64;
const MOST_STATES = 64;
/** Characters; a link keeps no more of a name. */
export const LONGEST_NAME = 60;

const kept = signal<readonly OwnShape[]>(load());

/** The latest first. */
export const ownShapes: ReadonlySignal<readonly OwnShape[]> = kept;

/** Keeps a shape as it is now. What stands in the way of that comes back in words. */
export function keepShape(shape: Shape): string | null {
  const { preset: _, ...kept } = withExact(shape, exactOf(shape));
  return keep(kept);
}

/** The same with a shape of several states. */
export function keepDirected({ name, states, outline }: DirectedShape): string | null {
  return keep({ name, maps: [], states, ...(outline === undefined ? {} : { outline }) });
}

function keep(shape: Omit<OwnShape, "id">): string | null {
  if (kept.peek().length >= MOST_SHAPES) return messages.tooManyShapes(MOST_SHAPES);
  const one = { id: crypto.randomUUID(), ...shape, name: shape.name.slice(0, LONGEST_NAME) };
  return save([one, ...kept.peek()]);
}

/** What a copy is called: "Fern 2" of "Fern", the next number that is free. */
export function copyName(name: string, taken: ReadonlySet<string>): string {
  const stem = name.replace(/ \d+$/, "").slice(0, LONGEST_NAME - 4);
  for (let number = 2; ; number++) {
    const next = `${stem} ${number}`;
    if (next !== name && !taken.has(next)) return next;
  }
}

export function renameOwnShape(id: string, name: string): string | null {
  const given = name.trim().slice(0, LONGEST_NAME);
  return given === ""
    ? messages.nameIsEmpty
    : save(kept.peek().map((one) => (one.id === id ? { ...one, name: given } : one)));
}

export function removeOwnShape(id: string): string | null {
  return save(kept.peek().filter((one) => one.id !== id));
}

/** What the browser's storage holds, without what can be no shape: other programs of this address write there, too. */
export function readShapes(text: string | null): OwnShape[] {
  let rows: unknown;
  try {
    rows = JSON.parse(text ?? "[]");
  } catch {
    return [];
  }
  return Array.isArray(rows) ? rows.flatMap((row) => sound(row) ?? []).slice(0, MOST_SHAPES) : [];
}

function sound(row: unknown): OwnShape | null {
  if (typeof row !== "object" || row === null) return null;
  const { id, name, maps, weights, exact, states, outline } = row as Record<string, unknown>;
  if (typeof id !== "string" || typeof name !== "string" || !Array.isArray(maps)) return null;
  if (areStates(states)) {
    const one = { id, name: name.slice(0, LONGEST_NAME), maps: [], states };
    return typeof outline === "string" ? { ...one, outline } : one;
  }
  if (maps.length === 0 || maps.length > MOST_MAPS || !maps.every(isMap)) return null;
  const one = { id, name: name.slice(0, LONGEST_NAME), maps, ...formulas(exact) };
  return areWeights(weights, maps.length) ? { ...one, weights } : one;
}

/** Those that a link takes: `crate/scene/src/link/words.rs`. */
function formulas(list: unknown) {
  return Array.isArray(list) ? { exact: list.filter((one) => /^[a-z0-9./()*+-]{1,200}$/.test(one)) } : {};
}

function areWeights(list: unknown, count: number): list is number[] {
  if (!Array.isArray(list) || list.length !== count) return false;
  return list.every((weight) => Number.isFinite(weight) && weight >= 0) && list.some((weight) => weight > 0);
}

function areStates(list: unknown): list is DirectedMap[][] {
  if (!Array.isArray(list) || list.length === 0 || list.length > MOST_STATES) return false;
  const isCopy = (copy: unknown) => {
    if (typeof copy !== "object" || copy === null) return false;
    const { from, map } = copy as Record<string, unknown>;
    return Number.isInteger(from) && Number(from) >= 0 && Number(from) < list.length && isMap(map);
  };
  return list.every(
    (state) => Array.isArray(state) && state.length > 0 && state.length <= MOST_MAPS && state.every(isCopy),
  );
}

function isMap(map: unknown): map is MapRow {
  return Array.isArray(map) && map.length === 6 && map.every((number) => Number.isFinite(number));
}

function load(): OwnShape[] {
  try {
    return readShapes(localStorage.getItem(KEY));
  } catch {
    return [];
  }
}

/** They stay for this visit even where the browser keeps nothing. */
function save(next: readonly OwnShape[]): string | null {
  kept.value = next;
  try {
    localStorage.setItem(KEY, JSON.stringify(next));
    return null;
  } catch {
    return messages.shapesNotStored;
  }
}

// Another tab has changed them.
globalThis.addEventListener?.("storage", (event) => {
  if (event.key === KEY || event.key === null) kept.value = load();
});
