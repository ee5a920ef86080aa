/** What the panel says. */

import { formatNumber } from "#format/numbers";
import { significant } from "#format/significant";
import type { Assembled, HoughCluster, HoughClusters } from "#workers/fit/hough";
import * as messages from "../messages";
import type { Kind } from "./model";

export const KINDS: readonly { value: Kind; label: string; about: string }[] = [
  { value: "fif", label: messages.whole, about: messages.fifEveryPieceSmaller },
  {
    value: "rfif",
    label: messages.stretch,
    about: messages.rfifEveryPieceSmaller,
  },
  { value: "pfif", label: messages.anyPart, about: messages.pfifEveryPieceSmaller },
];

const LETTERS = ["a", "b", "c", "d", "e"] as const;

/** What a cluster is called: numbers count from 1, by hits. */
export function nameOf({ kind, echo }: HoughCluster, index: number): string {
  if (kind === "clutter") return messages.clutterOf(index + 1);
  if (kind === "map") return messages.mapOf(index + 1);
  return messages.echoOf(
    echo.map(({ cluster, inverse }) => `${cluster + 1}${inverse ? "⁻¹" : ""}`).join(" "),
  );
}

/** The same at length. */
export function aboutOf({ kind, echo }: HoughCluster): string {
  if (kind === "clutter") return messages.soSmallAlmostEverything;
  if (kind === "map") return messages.mapOwn;
  const steps = [...echo].reverse().map(({ cluster, inverse }) => {
    return inverse ? messages.undoMap(cluster + 1) : messages.applyMap(cluster + 1);
  });
  return messages.followsFrom(steps.join(", then "));
}

export function mapWords(map: readonly number[]): string {
  return map.map((x, i) => `${LETTERS[i]} ${formatNumber(x, 3)}`).join(", ");
}

/** How near a copy comes, in percent of the height, and on how many coarse feature points. */
export function errorWords({ candidate }: HoughCluster): string {
  if (!candidate) return messages.fitsNowhere;
  const percent = 100 * candidate.rms;
  const off = percent < 0.01 ? "< 0.01" : formatNumber(percent, 2);
  return messages.errorOn(off, candidate.points);
}

/** How far a graph is from what is measured, in the units of the heights. */
export function offWords({ worst, meanSquare }: { worst: number; meanSquare: number }): string {
  return messages.errorAtMost(significant(worst), significant(Math.sqrt(meanSquare)));
}

/** What a graph within a tolerance costs, beside the polyline that is as near. */
export function costWords({
  numbers,
  polyline,
  graph,
}: Pick<Assembled, "numbers" | "polyline" | "graph">): string {
  if (numbers === undefined || polyline === undefined) return "";
  if (graph.pieces.every(({ map }) => map[2] === 0)) {
    return messages.copiesDoNotPay(numbers);
  }
  return messages.costIs(numbers, polyline);
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
  return messages.spreadIn(percent(one + two), percent(one + two + three));
}

export function phaseWords(phase: "first" | "second" | "naming"): string {
  if (phase === "first") return messages.countingBC;
  return phase === "second" ? messages.countingDE : messages.naming;
}
