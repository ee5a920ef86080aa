import { type Screen, screen } from "#geometry/coordinates";

/** Places that would lie on each other, side by side: the later ones move to the right. */
export function apart(places: readonly Screen[], least: number): Screen[] {
  const taken: Screen[] = [];
  for (const place of places) {
    let at = place;
    // One of those that are there is passed in each round.
    for (let rounds = 0; rounds < taken.length; rounds++) {
      const near = taken.find((other) => Math.hypot(other.x - at.x, other.y - at.y) < least);
      if (!near) break;
      at = screen(near.x + Math.sqrt(Math.max(0, least ** 2 - (near.y - at.y) ** 2)) + 1e-6, at.y);
    }
    taken.push(at);
  }
  return taken;
}
