/** What a mesh is to be. Pure, for the tests. */
import { bytesWords } from "#film/plan";
import { formatNumber } from "#format/numbers";
import type { MeshFacts, MeshFormat, MeshOptions } from "#wasm/api";
import type { MeshMeasured } from "#workers/space/mesh";
import * as messages from "../messages";

export interface MeshPlan extends Required<MeshOptions> {
  format: MeshFormat;
}

export const LEAST_FINENESS = 16;
export const MOST_FINENESS = 640;
/** As crate/render/src/mesh/mesher.rs has them. */
const MOST_SAMPLES = 32e6;
const MOST_TRIANGLES = 6e6;
const LEAST_WALL_SAMPLES = 3;
/** A mesh of so many samples along its longest side is there at once. */
const QUICK = 96;
const COARSE = 48;

/** At which finenesses a mesh is measured, from which a finer one is told. */
export const measuredAt = (fineness: number): number[] => (fineness <= QUICK ? [fineness] : [COARSE, QUICK]);

/** How thick its walls are, whatever was asked for. */
export const wallOf = ({ fineness, size, wall }: MeshPlan): number =>
  Math.max(wall, (LEAST_WALL_SAMPLES * size) / fineness);

/** What a mesh will be, from coarser ones of the same shape, the coarsest first. */
export interface Foretold extends Pick<MeshFacts, "triangles" | "size" | "parts"> {
  /** Points that will be found. */
  found: number;
  /** Whether that is what it will be, or about that. */
  exact: boolean;
}

export function foretell(
  fineness: number,
  measured: readonly { fineness: number; facts: MeshMeasured }[],
): Foretold | null {
  const last = measured.at(-1);
  const first = measured[0];
  if (!last || !first) return null;
  const { triangles, size, parts, found } = last.facts;
  if (last.fineness === first.fineness) return { triangles, size, parts, found, exact: true };
  const grown = (of: "triangles" | "found") => {
    // The surface of a fractal grows faster than the square of the fineness, and no faster than its cube.
    const power = Math.log(last.facts[of] / first.facts[of]) / Math.log(last.fineness / first.fineness);
    const kept = Math.min(3, Math.max(1, Number.isFinite(power) ? power : 2));
    return last.facts[of] * (fineness / last.fineness) ** kept;
  };
  return { triangles: grown("triangles"), size, parts, found: grown("found"), exact: false };
}

/** Why it cannot be made, in words that say what to do; null where it can. */
export function meshProblem({ fineness, size }: MeshPlan, foretold: Foretold | null): string | null {
  if (!foretold) return null;
  const step = size / fineness;
  const samples = foretold.size.reduce((count, side) => count * (side / step + 5), 1);
  if (samples > MOST_SAMPLES) {
    const most = Math.floor(0.98 * fineness * Math.cbrt(MOST_SAMPLES / samples));
    return messages.tooMuchMemory(most);
  }
  if (foretold.triangles > MOST_TRIANGLES) {
    return messages.tooManyTriangles(million(foretold.triangles));
  }
  return null;
}

export function meshWords({ triangles, size, exact }: Foretold, bytes: number): string {
  const sides = size.map((side) => formatNumber(side, side < 10 ? 1 : 0)).join(" × ");
  const about = exact ? "" : "about ";
  return messages.meshSize(sides, about, million(triangles), about, bytesWords(bytes));
}

/** What there is to know before it is printed. */
export function adviceOf(plan: MeshPlan, { parts }: Foretold): string[] {
  const advice: string[] = [];
  const wall = wallOf(plan);
  if (wall > plan.wall * 1.001) {
    advice.push(messages.wallsAre(formatNumber(wall, 2)));
  }
  if (parts > 1) {
    advice.push(messages.inParts(parts));
  }
  return advice;
}

function million(count: number): string {
  if (count >= 1e6) return messages.million(formatNumber(count / 1e6, 1));
  return count >= 1e4 ? `${formatNumber(count / 1000, 0)} 000` : formatNumber(count, 0);
}
