/** On which side of the straight way a waypoint lies: turned first, or moved first. */
import type { Uv } from "#geometry/path";

export type Side = "turning first" | "moving first" | "on the line";

export function sideOf([u, v]: Uv): Side {
  return u > v + 1e-9 ? "turning first" : v > u + 1e-9 ? "moving first" : "on the line";
}
