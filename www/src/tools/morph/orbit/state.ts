/** The point that is followed on the stage, and the game that may be played with it. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { bend } from "#document/deform/bend";
import { type Box, boxOf } from "#document/framing";
import { ownWeights } from "#document/morph";
import type { Screen } from "#geometry/coordinates";
import { toScreen, toWorld, world } from "#geometry/coordinates";
import { imageOf } from "#geometry/maps/affine2";
import { isInvertible, orbitOf, type Point } from "#geometry/maps/orbit";
import {
  type Board,
  cellOf,
  DEEPEST,
  hullOf,
  isIn,
  middleOf,
  newTarget,
  unplayable,
} from "#geometry/maps/target";
import { mainMaps } from "#stage/stage";
import { effectiveView, stageSize } from "#stage/view";
import { choose, factsOf, follow, type Orbit, turnTo } from "#ui/orbit/follow";
import { type Asked, gameOf } from "#ui/orbit/game";
import { type Game, MOST_THROWS, orbitWords } from "#ui/orbit/words";
import * as messages from "./messages";

/** As near as a finger comes, in CSS pixels. */
const REACH = 16;

const box: ReadonlySignal<Box | null> = computed(() => boxOf(mainMaps.value));

/** Why no point can be followed, in words; null where one can. */
export const hindrance: ReadonlySignal<string | null> = computed(() => {
  if (bend.value) return messages.shapeDeformedSoPoints;
  if (!box.value) return messages.theseMapsHaveNo;
  return null;
});

const kept = signal<Orbit | null>(null);

/** What is followed: at first a point in the middle, to which nothing has been done. */
export const orbit: ReadonlySignal<Orbit> = computed(
  () => kept.value ?? { way: "apply", start: middle(box.value), letters: [] },
);
export const setOrbit = (next: Orbit): void => {
  kept.value = next;
};

/** A little off the middle, which on many shapes is a special point. */
function middle(at: Box | null): Point {
  if (!at) return [0, 0];
  return short([at.x0 + 0.45 * (at.x1 - at.x0), at.y0 + 0.55 * (at.y1 - at.y0)]);
}

/** As few digits as a hundredth of a pixel needs. */
function short([x, y]: Point): Point {
  const digits = Math.min(14, Math.max(3, Math.ceil(Math.log10(100 * effectiveView.peek().scale))));
  return [Number(x.toFixed(digits)), Number(y.toFixed(digits))];
}

export const followed = computed(() => follow(mainMaps.value, orbit.value));

export const words = computed(() => {
  const at = box.value;
  if (!at) return "";
  const maps = mainMaps.value;
  const isFlat = (letter: number) => {
    const map = maps[letter];
    return map !== undefined && !isInvertible(map);
  };
  return orbitWords(orbit.value, followed.value, factsOf(maps, at, orbit.value), isFlat);
});

const reach = () => REACH / effectiveView.peek().scale;

export function goTo(point: Point, near = reach()): void {
  const at = box.peek();
  if (at) setOrbit(choose(orbit.peek(), mainMaps.peek(), at, point, near));
}

export function setWay(way: "apply" | "read"): void {
  const at = box.peek();
  if (at) setOrbit(turnTo(way, orbit.peek(), mainMaps.peek(), at, reach()));
}

export function takeNearest(): void {
  const now = orbit.peek();
  if (now.way === "off" && now.nearest) setOrbit({ way: "read", address: now.nearest, count: now.count });
}

/** The point that was chosen, where it is on the stage. */
export const grip: ReadonlySignal<Screen> = computed(() => place(followed.value.points[0] ?? [0, 0]));

export const place = ([x, y]: Point): Screen => toScreen(world(x, y), effectiveView.value, stageSize.value);

export function pointAtScreen(at: Screen): Point {
  const { x, y } = toWorld(at, effectiveView.peek(), stageSize.peek());
  return short([x, y]);
}

/** How often each map is thrown, where the document says so. */
export const weights = ownWeights;

/** Whether it is played for a cell. */
export const playing = signal(false);
const asked = signal<Asked | null>(null);

/** Why there is no game on this shape; null where there is one. */
export const gameProblem = computed(() => unplayable(mainMaps.value));

export const board: ReadonlySignal<Board> = computed(() => {
  const hull = hullOf(mainMaps.value);
  return { maps: mainMaps.value, hull, start: middleOf(hull) };
});

/** All ways to a cell are tried: of many maps only the larger cells. */
const MOST_WAYS = 1500;
export const deepest = computed(() => {
  const count = Math.max(2, mainMaps.value.length);
  return Math.max(1, Math.min(DEEPEST, 1 + Math.floor(Math.log(MOST_WAYS) / Math.log(count))));
});

const FIRST_LENGTH = 2;
/** What was asked for, as long as the maps are there that it names. */
const current = computed<Asked>(() => {
  const count = mainMaps.value.length;
  const now = asked.value;
  if (now && [...now.target, ...now.letters].every((letter) => letter < count)) return now;
  const target = newTarget(board.value, Math.min(FIRST_LENGTH, deepest.value), 1);
  return { target, letters: [], shown: false };
});

export const throws = computed(() => current.value.letters);
export const thrownPoints = computed(() => orbitOf(board.value.maps, board.value.start, throws.value));
export const cell = computed(() => cellOf(board.value, current.value.target));

export const game: ReadonlySignal<Game> = computed(() => gameOf(board.value, current.value));

export function throwTo(letter: number): void {
  const { letters } = current.peek();
  if (game.peek().reached || letters.length >= MOST_THROWS) return;
  asked.value = { ...current.peek(), letters: [...letters, letter], shown: false };
}

export function throwBack(): void {
  asked.value = { ...current.peek(), letters: current.peek().letters.slice(0, -1), shown: false };
}

export function throwAgain(): void {
  asked.value = { ...current.peek(), letters: [], shown: false };
}

export function showWay(): void {
  asked.value = { ...current.peek(), letters: game.peek().way, shown: true };
}

export function nextTarget(length: number): void {
  const before = current.peek().target.join();
  let target: number[] = [];
  // Another one, where there is another.
  for (let tries = 0; tries < 20; tries++) {
    target = newTarget(board.peek(), length, Math.floor(Math.random() * 2 ** 31));
    if (target.join() !== before) break;
  }
  asked.value = { target, letters: [], shown: false };
}

/** The map whose piece was pressed, or whose piece is nearest to where it was pressed. */
export function mapAt(point: Point): number {
  const { maps, hull } = board.peek();
  const within = maps.findIndex((_, letter) => isIn(board.peek(), [letter], point));
  if (within >= 0) return within;
  const center = middleOf(hull);
  const far = maps.map((map) => {
    const [x, y] = imageOf(map, center);
    return Math.hypot(x - point[0], y - point[1]);
  });
  return far.indexOf(Math.min(...far));
}
