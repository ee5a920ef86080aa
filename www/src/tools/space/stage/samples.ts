import { apply3 } from "#geometry/maps/affine3";
import type { MapRow3, Point3 } from "#wasm/api";
import { solid } from "#wasm/space";

/** So many points at random. */
const RANDOM = 400;
/** So many steps lead to where a map keeps still, as near as a picture shows. */
const STEPS = 64;

/**
 * Points of an attractor that stand for all of it in a picture. Points at random miss its corners, which often are
 * where a map, or a map after another, keeps still: these are among them.
 */
export function standFor(maps: readonly MapRow3[]): Point3[] {
  const { positions } = solid.attractor3([...maps], { points: RANDOM, seed: 1 });
  const random = Array.from(
    { length: positions.length / 3 },
    (_, i): Point3 => [positions[3 * i] ?? 0, positions[3 * i + 1] ?? 0, positions[3 * i + 2] ?? 0],
  );
  const [start] = random;
  if (!start) return [];
  // All of these are points of the attractor, however slowly a map contracts.
  const still = maps.map((map) =>
    Array.from({ length: STEPS }).reduce((at: Point3) => apply3(map, at), start),
  );
  return [...random, ...still, ...maps.flatMap((map) => still.map((at) => apply3(map, at)))];
}
