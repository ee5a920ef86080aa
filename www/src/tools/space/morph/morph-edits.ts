/** What the panel does to the morph, as functions from space to space. */
import type { MapRow3, Mode, MorphOptions, PathPoint, Shape3, Space, SpaceMorph } from "#wasm/api";
import { withKeys, withoutMorph } from "../shape/object-edits";

export { withoutMorph };

/** As many as a link may hold. */
export const MOST_POINTS = 64;

/**
 * Leads the first object to a shape; `order` says which map becomes which. What was chosen of the morph before stays.
 */
export function leadingTo(space: Space, to: Shape3, order: readonly number[]): Space {
  const before = space.morph;
  const morph: SpaceMorph = {
    to,
    path: { kind: "auto", points: [] },
    t: before?.t ?? 0,
    ...(before?.mode ? { mode: before.mode } : {}),
    ...orderOf(order),
  };
  // What keys said of its maps would fight with it.
  return withKeys({ ...space, morph }, ({ maps, ...key }) => {
    const left = maps?.map((item, i) => (i === 0 ? null : item));
    return left?.some((item) => item !== null) ? { ...key, maps: left } : key;
  });
}

/** These two alone. */
export function startingWith(space: Space, from: Shape3, to: Shape3, order: readonly number[]): Space {
  return leadingTo({ objects: [from], light: space.light }, to, order);
}

/** The same morph, run from the other side. */
export function swapped(space: Space): Space {
  const { morph } = space;
  const [first, ...others] = space.objects;
  if (!morph || !first) return space;
  const { moved, tint } = first;
  const { correspondence = [], turns = [], ...rest } = morph;
  const back: number[] = [];
  correspondence.forEach((to, from) => {
    back[to] = from;
  });
  const returning: number[] = [];
  turns.forEach((turn, from) => {
    returning[correspondence[from] ?? from] = turn === 0 ? 0 : -turn;
  });
  const after: Space = {
    ...space,
    objects: [{ ...morph.to, ...(moved ? { moved } : {}), ...(tint ? { tint } : {}) }, ...others],
    morph: {
      ...rest,
      to: shapeOf(first),
      path: { ...morph.path, points: morph.path.points.map(across).reverse() },
      t: opposite(morph.t),
      ...(back.length > 0 ? { correspondence: back } : {}),
      ...(returning.length > 0 ? { turns: returning } : {}),
    },
  };
  return withKeys(after, (key) => (key.t === undefined ? key : { ...key, t: opposite(key.t) }));
}

/** Without the digits that rounding makes up. */
const opposite = (x: number) => Math.round((1 - x) * 1e9) / 1e9;
const across = ([u, v, w = 0]: PathPoint): PathPoint =>
  w === 0 ? [opposite(u), opposite(v)] : [opposite(u), opposite(v), -w];

function shapeOf({ preset, name, maps }: Shape3): Shape3 {
  return { ...(preset === undefined ? {} : { preset }), name, maps };
}

export function withMode(space: Space, mode: Mode): Space {
  return changed(space, (morph) => replanned({ ...morph, mode }));
}

/** Which map becomes which. Whole extra turns belong to pairs that are no more. */
export function withOrder(space: Space, order: readonly number[]): Space {
  return changed(space, ({ correspondence: _, turns: __, ...morph }) =>
    replanned({ ...morph, ...orderOf(order) }),
  );
}

/** Each map turns by so many whole turns more. */
export function turnedFurther(space: Space, by: readonly number[]): Space {
  return changed(space, ({ turns: before = [], ...morph }) => {
    const turns = by.map((turn, i) => turn + ((before.length === by.length && before[i]) || 0));
    return replanned(turns.every((turn) => turn === 0) ? morph : { ...morph, turns });
  });
}

export function withPath(space: Space, path: SpaceMorph["path"]): Space {
  return changed(space, (morph) => ({
    ...morph,
    path: { ...path, points: path.points.slice(0, MOST_POINTS) },
  }));
}

/** A path that was found for another morph says nothing of this one; one that was drawn stays. */
function replanned(morph: SpaceMorph): SpaceMorph {
  return morph.path.kind === "auto" ? { ...morph, path: { kind: "auto", points: [] } } : morph;
}

function changed(space: Space, change: (morph: SpaceMorph) => SpaceMorph): Space {
  return space.morph ? { ...space, morph: change(space.morph) } : space;
}

/** What goes without saying is left out of the document. */
function orderOf(order: readonly number[]): { correspondence?: number[] } {
  return inOrder(order) ? {} : { correspondence: [...order] };
}

export function inOrder(order: readonly number[]): boolean {
  return order.every((to, from) => to === from);
}

/** The order of a morph in full. */
export function orderNow({ correspondence = [] }: MorphOptions, count: number): number[] {
  return correspondence.length === count ? correspondence : Array.from({ length: count }, (_, i) => i);
}

/** One map gets another partner; the one that had it takes the partner that is left. */
export function exchanged(order: readonly number[], from: number, to: number): number[] {
  const before = order[from];
  return order.map((partner, i) => (i === from ? to : partner === to ? (before ?? partner) : partner));
}

/** What the module is asked with: lists of the wrong length count as the default. */
export function optionsOf({ mode, correspondence, turns }: MorphOptions, count: number): MorphOptions {
  return {
    mode: mode ?? "polar",
    ...(correspondence?.length === count ? { correspondence } : {}),
    ...(turns?.length === count ? { turns } : {}),
  };
}

/** Pairs, numbered from 1, of which one map reflects and the other does not: on the way it must become flat. */
export function flatPairs(
  from: readonly MapRow3[],
  to: readonly MapRow3[],
  order: readonly number[],
): number[] {
  return from.flatMap((map, i) => {
    const partner = to[order[i] ?? i];
    return partner && determinant(map) * determinant(partner) < 0 ? [i + 1] : [];
  });
}

function determinant([a, b, c, d, e, f, g, h, i]: MapRow3): number {
  return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
}
