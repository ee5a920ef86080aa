/** What the panel says. */

import { formatNumber } from "#format/numbers";
import { significant } from "#format/significant";
import type { Assembled, HoughCluster, HoughClusters } from "#workers/fit/hough";
import type { Kind } from "./model";

export const KINDS: readonly { value: Kind; label: string; about: string }[] = [
  { value: "fif", label: "The whole", about: "FIF: every piece is a smaller copy of the whole graph." },
  {
    value: "rfif",
    label: "A stretch",
    about: "RFIF: every piece is a smaller copy of what lies between two of the points.",
  },
  { value: "pfif", label: "Any part", about: "PFIF: every piece is a smaller copy of any longer part." },
];

const LETTERS = ["a", "b", "c", "d", "e"] as const;

/** What a cluster is called: numbers count from 1, by hits. */
export function nameOf({ kind, echo }: HoughCluster, index: number): string {
  if (kind === "clutter") return `Clutter ${index + 1}`;
  if (kind === "map") return `Map ${index + 1}`;
  return `Echo ${echo.map(({ cluster, inverse }) => `${cluster + 1}${inverse ? "⁻¹" : ""}`).join(" ")}`;
}

/** The same at length. */
export function aboutOf({ kind, echo }: HoughCluster): string {
  if (kind === "clutter") return "So small that almost everything is a copy of it.";
  if (kind === "map") return "A map of its own.";
  const steps = [...echo].reverse().map(({ cluster, inverse }) => {
    return inverse ? `undo map ${cluster + 1}` : `do map ${cluster + 1}`;
  });
  return `It follows from stronger ones: ${steps.join(", then ")}.`;
}

export function mapWords(map: readonly number[]): string {
  return map.map((x, i) => `${LETTERS[i]} ${formatNumber(x, 3)}`).join(", ");
}

/** How near a copy comes, in percent of the height, and on how many coarse feature points. */
export function errorWords({ candidate }: HoughCluster): string {
  if (!candidate) return "holds nowhere";
  const percent = 100 * candidate.rms;
  const off = percent < 0.01 ? "< 0.01" : formatNumber(percent, 2);
  return `${off}% off on ${candidate.points}`;
}

/** How far a graph is from what is measured, in the units of the heights. */
export function offWords({ worst, meanSquare }: { worst: number; meanSquare: number }): string {
  return `off by ${significant(worst)} at most, ${significant(Math.sqrt(meanSquare))} in the root mean square`;
}

/** What a graph within a tolerance costs, beside the polyline that is as near. */
export function costWords({
  numbers,
  polyline,
  graph,
}: Pick<Assembled, "numbers" | "polyline" | "graph">): string {
  if (numbers === undefined || polyline === undefined) return "";
  if (graph.pieces.every(({ map }) => map[2] === 0)) {
    return `A polyline of ${numbers} numbers: copies do not pay at this tolerance.`;
  }
  return `It is made of ${numbers} numbers; a polyline that is as near takes ${polyline}.`;
}

export function countWords(count: number): string {
  return count.toLocaleString("en-GB");
}

/** A direction of the space in its two or three largest parts. */
export function axisWords(axis: readonly number[]): string {
  const parts = axis
    .map((x, i) => ({ x, name: LETTERS[i] ?? "" }))
    .filter(({ x }) => Math.abs(x) >= 0.25)
    .sort((p, q) => Math.abs(q.x) - Math.abs(p.x))
    .slice(0, 3);
  return parts
    .map(({ x, name }, i) => {
      const size = formatNumber(Math.abs(x), 2);
      return `${x < 0 ? "− " : i > 0 ? "+ " : ""}${size} ${name}`;
    })
    .join(" ");
}

export function spreadWords(space: NonNullable<HoughClusters["space"]>): string {
  const percent = (n: number) => `${formatNumber(100 * n, 0)}%`;
  const [one, two, three] = space.shares;
  return `${percent(one + two)} of the spread lies in these two directions, ${percent(one + two + three)} in three.`;
}

export function phaseWords(phase: "first" | "second" | "naming"): string {
  if (phase === "first") return "Counting a, b, c";
  return phase === "second" ? "Counting d, e" : "Naming";
}
