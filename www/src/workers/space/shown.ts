import type { SpaceFrame, SpaceObject, SpaceShown } from "#wasm/api";

/** What a picture shows of an object at a moment. */
export function shownObject(
  { maps, moved, now, bend: moves }: SpaceFrame["objects"][number],
  object: Pick<SpaceObject, "tint" | "bend"> | undefined,
): SpaceShown {
  const { tint, bend } = object ?? {};
  return {
    maps: now,
    ...(tint === undefined ? {} : { tint }),
    ...(bend === undefined ? {} : { bent: { maps, moved, bend: moves ? { ...bend, moves } : bend } }),
  };
}
