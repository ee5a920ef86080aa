/** What the panel does to the objects of space, as functions from space to space. */

import { about3, after3, scale3, shift3 } from "#geometry/maps/affine3";
import type { MapRow3, Point3, Shape3, Space, SpaceKey, SpaceObject } from "#wasm/api";

export const MOST_MAPS = 64;
export const MOST_OBJECTS = 60;

/**
 * Another shape for an object, in its place and bent alike. What was said of other numbers of its maps is no longer
 * so.
 */
export function withShape(space: Space, index: number, shape: Shape3): Space {
  const before = space.objects[index];
  if (!before) return space;
  const { moved, tint, bend } = before;
  const object: SpaceObject = {
    ...shape,
    ...(moved ? { moved } : {}),
    ...(tint ? { tint } : {}),
    ...(bend ? { bend } : {}),
  };
  const objects = space.objects.map((old, i) => (i === index ? object : old));
  const after = { ...space, objects };
  if (before.maps.length === shape.maps.length) return after;
  const kept = index === 0 ? withoutMorph(after) : after;
  return withKeys(kept, (key) => ({
    ...key,
    ...changed("maps", key.maps, (list) => put(list, index, null)),
  }));
}

/** One more object, behind the others. */
export function withObject(space: Space, object: SpaceObject): Space {
  return space.objects.length < MOST_OBJECTS ? { ...space, objects: [...space.objects, object] } : space;
}

/** Without an object, nor what the time line and the morph say of it. The last one stays. */
export function withoutObject(space: Space, index: number): Space {
  if (space.objects.length < 2 || !space.objects[index]) return space;
  const left = { ...space, objects: space.objects.filter((_, i) => i !== index) };
  const drop = <T>(list: readonly T[]) => list.filter((_, i) => i !== index);
  return withKeys(index === 0 ? withoutMorph(left) : left, (key) => ({
    ...key,
    ...changed("moved", key.moved, drop),
    ...changed("maps", key.maps, drop),
    ...changed("bends", key.bends, drop),
  }));
}

/** One colour for all of an object; null: its maps have theirs. */
export function withTint(space: Space, index: number, tint: string | null): Space {
  return {
    ...space,
    objects: space.objects.map((object, i) => {
      if (i !== index) return object;
      const { tint: _, ...rest } = object;
      return tint === null ? rest : { ...rest, tint };
    }),
  };
}

export function withoutMorph(space: Space): Space {
  const { morph: _, ...rest } = space;
  return withKeys(rest, ({ t: _, ...key }) => key);
}

/** Keys that say nothing any more are gone, and with the last of them the time line. */
export function withKeys(space: Space, change: (key: SpaceKey) => SpaceKey): Space {
  const { timeline, ...rest } = space;
  if (!timeline) return space;
  const says = ({ view, moved, maps, t }: SpaceKey) =>
    view !== undefined ||
    t !== undefined ||
    [...(moved ?? []), ...(maps ?? [])].some((item) => item !== null);
  const keys = timeline.keys.map(change).filter(says);
  return keys.length > 0 ? { ...rest, timeline: { ...timeline, keys } } : rest;
}

function changed<K extends "moved" | "maps" | "bends", T>(
  name: K,
  list: T | undefined,
  change: (list: T) => T,
): Partial<Record<K, T>> {
  return list === undefined ? {} : ({ [name]: change(list) } as Partial<Record<K, T>>);
}

function put<T>(list: readonly T[], index: number, item: T): T[] {
  return list.map((old, i) => (i === index ? item : old));
}

export interface Ball {
  centre: Point3;
  radius: number;
}

/** A ball around balls: not the least one, but one that is soon found. */
export function around(balls: readonly Ball[]): Ball {
  const middle = [0, 1, 2].map((k) => {
    const low = Math.min(...balls.map(({ centre, radius }) => (centre[k] ?? 0) - radius));
    const high = Math.max(...balls.map(({ centre, radius }) => (centre[k] ?? 0) + radius));
    return (low + high) / 2;
  });
  const centre: Point3 = [middle[0] ?? 0, middle[1] ?? 0, middle[2] ?? 0];
  const reach = ({ centre: c, radius }: Ball) =>
    Math.hypot(...c.map((x, k) => x - (centre[k] ?? 0))) + radius;
  return { centre, radius: Math.max(...balls.map(reach)) };
}

/** What brings a shape to the side of all others, as large as one of them is. */
export function beside(shape: Ball, all: Ball, radius: number): MapRow3 {
  const factor = shape.radius > 0 ? radius / shape.radius : 1;
  const scaled = about3(scale3([factor, factor, factor]), shape.centre);
  const [x, y, z] = all.centre;
  const goal: Point3 = [x + all.radius + 1.1 * radius, y, z];
  return after3(shift3(goal.map((at, k) => at - (shape.centre[k] ?? 0)) as Point3), scaled);
}
