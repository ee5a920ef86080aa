import type { SpaceView } from "#wasm/api";

/** A view that can be looked from, or nothing. */
export function viewIn(value: unknown): SpaceView | null {
  if (typeof value !== "object" || value === null) return null;
  const { target, distance, turn, tilt, angle, holds } = value as Record<string, unknown>;
  const number = (x: unknown): x is number =>
    typeof x === "number" && Number.isFinite(x) && Math.abs(x) < 1e9;
  if (!Array.isArray(target) || target.length !== 3 || !target.every(number)) return null;
  if (!number(distance) || distance <= 0 || !number(turn) || !number(tilt)) return null;
  if (!number(angle) || angle <= 0 || angle >= Math.PI) return null;
  const [x, y, z] = target as [number, number, number];
  const view: SpaceView = { target: [x, y, z], distance, turn, tilt, angle };
  return holds === "eye" ? { ...view, holds } : view;
}
