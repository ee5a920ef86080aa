/** What clusters of votes are called on the page, and which printed rows they are. */
import type { HoughCluster } from "#workers/fit/hough";
import { type ShearMap, TABLE_1 } from "../graphs/printed-tables";

/** So far may two maps be from each other and still be one: some bins of a, b, c, d and e. */
const SAME_MAP: ShearMap = [0.04, 0.13, 0.05, 0.05, 0.16];
const UNDONE = "⁻¹";

/** How far two maps are from each other in these units; 1 is the farthest that still counts. */
export function apartIn(one: ShearMap, other: ShearMap): number {
  return Math.max(...one.map((x, i) => Math.abs(x - (other[i] ?? 0)) / (SAME_MAP[i] ?? 1)));
}

/** Index of the nearest of some maps, or null where none is near. */
export function nearestOf(map: ShearMap, others: readonly ShearMap[]): number | null {
  const far = others.map((other) => apartIn(map, other));
  const least = Math.min(...far);
  return least <= 1 ? far.indexOf(least) : null;
}

/** T₁ and T₂ where it is one of Table 1's, else its rank. */
export function letterOf(found: readonly HoughCluster[], index: number): string {
  const cluster = found[index];
  const known = cluster
    ? nearestOf(
        cluster.map,
        TABLE_1.map(({ map }) => map),
      )
    : null;
  return known === null ? `#${index + 1}` : `T${String.fromCharCode(0x2081 + known)}`;
}

/** A map, an echo with what it is composed of, or clutter; `letter` names maps. */
export function kindWords(
  cluster: HoughCluster,
  index: number,
  letter: (index: number) => string = (i) => `#${i + 1}`,
): string {
  if (cluster.kind === "clutter") return "clutter";
  if (cluster.kind === "map") {
    const name = letter(index);
    return name.startsWith("T") ? `${name} itself` : "a map";
  }
  const word = cluster.echo.map((step) => `${letter(step.cluster)}${step.inverse ? UNDONE : ""}`);
  return `echo: ${word.join(" ")}`;
}

/** Colours of the kinds: numbers in the palette. */
export const KIND_COLOURS = { map: 5, echo: 1, clutter: 7 } as const;
