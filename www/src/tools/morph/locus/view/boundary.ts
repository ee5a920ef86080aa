/** Where what holds ends: the way to it, from where all looks the same. */
import type { Field } from "#compute/locus/pyramid";
import { partWords } from "#format/path-words";
import { OWN_BOUNDS, resolutionWords } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { provedPart, STATE } from "#geometry/states";
import type { Bounds, Locus } from "#wasm/api";
import * as messages from "../messages";

/** What a map says of a sample, as far as colours tell: it holds, it is broken, or neither is known. */
export type Side = "holds" | "broken" | "unknown";

export function sideOf(state: number | undefined): Side {
  switch (state) {
    case STATE.connected:
    case STATE.touching:
      return "holds";
    case STATE.disconnected:
    case STATE.none:
    case STATE.hidden:
      return "broken";
    default:
      return "unknown";
  }
}

/** The one side that all of a field is on, if it is on one, and what part of it is proved: all of what is in pieces. */
export function uniform({ state }: Pick<Field, "state">): { side: Side; proved: number } | null {
  const side = sideOf(state[0]);
  if (side === "unknown") return null;
  for (const one of state) if (sideOf(one) !== side) return null;
  return { side, proved: provedPart(state) ?? 1 };
}

/** That side in a sentence: what is proved of it is told apart from what only looks so. */
export function sideWords({ side, proved }: { side: Side; proved: number }, epsilon: number): string {
  if (side === "broken") return messages.allInPieces(OWN_BOUNDS);
  if (proved === 1) return messages.allThisInOne;
  const looks = messages.allNoGap(resolutionWords(epsilon));
  return proved === 0 ? `${looks}.` : messages.partProved(looks, partWords(proved));
}

/**
 * Samples of a field that are on the other side of a place, the nearest first. What is proved to hold does so however
 * closely one looks, and what only looks whole may not: of that kind there are but so many, and the nearest that is
 * proved is the last.
 */
export function othersOf(
  field: Locus & { bounds: Bounds },
  [u, v]: Uv,
  side: Side,
  most = MOST_OTHERS,
): Uv[] {
  const { u0, v0, u1, v1 } = field.bounds;
  const [du, dv] = [(u1 - u0) / Math.max(1, field.width - 1), (v1 - v0) / Math.max(1, field.height - 1)];
  const others: { at: Uv; far: number; sure: boolean }[] = [];
  for (let j = 0; j < field.height; j++) {
    for (let i = 0; i < field.width; i++) {
      const state = field.state[j * field.width + i];
      const other = sideOf(state);
      if (other === side || other === "unknown") continue;
      const at: Uv = [u0 + i * du, v0 + j * dv];
      others.push({ at, far: Math.hypot(at[0] - u, at[1] - v), sure: state !== STATE.touching });
    }
  }
  others.sort((p, q) => p.far - q.far);
  const sure = others.findIndex((one) => one.sure);
  const chosen = others.slice(0, sure < 0 ? most : Math.min(most, sure));
  return [...chosen, ...(sure < 0 ? [] : others.slice(sure, sure + 1))].map(({ at }) => at);
}

/** So many that only look whole are looked at. */
const MOST_OTHERS = 96;

const COMPASS = [
  messages.toRight,
  messages.upAndToRight,
  "up",
  messages.upAndToLeft,
  messages.toLeft,
  messages.downAndToLeft,
  "down",
  messages.downAndToRight,
] as const;

/** A direction in words, by eighths of a turn. */
export function directionWords([u, v]: Uv, [x, y]: Uv): string {
  const eighth = Math.round((4 * Math.atan2(y - v, x - u)) / Math.PI);
  return COMPASS[((eighth % 8) + 8) % 8] ?? COMPASS[0];
}

/** Points of one round between two that are on different sides, and one more. */
export const PROBES = 16;

/** Places that divide a line evenly, its ends left out. */
export function probes([u, v]: Uv, [x, y]: Uv): Uv[] {
  return Array.from({ length: PROBES - 1 }, (_, k) => {
    const t = (k + 1) / PROBES;
    return [u + t * (x - u), v + t * (y - v)] as Uv;
  });
}

/** The first stretch of a line, so divided, on which the side changes: what is nearer to its start comes first. */
export function narrowed(from: Uv, to: Uv, states: ArrayLike<number>, side: Side): [from: Uv, to: Uv] {
  const between = probes(from, to);
  let last = from;
  for (const [k, at] of between.entries()) {
    const now = sideOf(states[k]);
    if (now !== side && now !== "unknown") return [last, at];
    if (now === side) last = at;
  }
  return [last, to];
}

/** Rounds of closing in: with 16 parts each, as near as numbers go. */
const MOST_ROUNDS = 13;

/**
 * The search for where the way out of a place first changes sides: first for a sample that is on the other side as
 * closely as one looks now, then between both.
 */
export class BoundarySearch {
  readonly #from: Uv;
  readonly #side: Side;
  readonly #close: (a: Uv, b: Uv) => boolean;
  #others: Uv[];
  #between: [Uv, Uv] | null = null;
  #asked: Uv[] = [];
  #rounds = 0;

  constructor(from: Uv, others: readonly Uv[], side: Side, close: (a: Uv, b: Uv) => boolean) {
    this.#from = from;
    this.#others = [...others];
    this.#side = side;
    this.#close = close;
  }

  /** What to look at next; nothing where all is known. */
  next(): Uv[] {
    if (this.#between === null) this.#asked = this.#others.splice(0, PROBES);
    else if (this.#rounds++ < MOST_ROUNDS && !this.#close(...this.#between))
      this.#asked = probes(...this.#between);
    else this.#asked = [];
    return this.#asked;
  }

  /** Takes the states of what was asked for. */
  take(states: ArrayLike<number>): void {
    if (this.#between) {
      this.#between = narrowed(...this.#between, states, this.#side);
      return;
    }
    const other = this.#asked.find((_, k) => {
      const now = sideOf(states[k]);
      return now !== this.#side && now !== "unknown";
    });
    if (other) this.#between = [this.#from, other];
  }

  /** Both sides of the boundary; null where there is none to be found. */
  get found(): readonly [Uv, Uv] | null {
    return this.#between;
  }
}
