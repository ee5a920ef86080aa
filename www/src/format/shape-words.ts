/** What a shape looks like, for those who do not see it. */
import type { Looks } from "#geometry/holes";
import type { Symmetries } from "#geometry/maps/symmetries";
import type { Connectedness, MapRow } from "#wasm/api";
import { formatNumber } from "./numbers";
import { lengthWords } from "./verdict";

export interface Described {
  name: string;
  maps: readonly MapRow[];
  box: { x0: number; y0: number; x1: number; y1: number } | null;
  symmetries: Symmetries;
  /** What is known of its pieces; null while nothing is. */
  answer: Pick<Connectedness, "verdict" | "overlaps"> | null;
  /** What a small picture of it shows; null where there is none. */
  looks: Looks | null;
}

/** As many pairs are named; more are counted. */
const MOST_PAIRS = 6;
/** More parts or holes than these nobody counts. */
const MOST_COUNTED = 50;

/** Its size, its copies, its symmetry, whether it is in one piece, where they touch, and its holes: in sentences. */
export function shapeWords({ name, maps, box, symmetries, answer, looks }: Described): string {
  const said = [`${name}: ${copiesWords(maps)}${box ? `, ${sizeWords(box)}` : ""}.`];
  const symmetry = symmetryWords(symmetries);
  if (symmetry) said.push(symmetry);
  if (answer) said.push(...piecesWords(answer, looks));
  if (looks && looks.parts > 0) said.push(holesWords(looks.holes));
  return said.join(" ");
}

export function sizeWords({ x0, y0, x1, y1 }: NonNullable<Described["box"]>): string {
  const [width, height] = [x1 - x0, y1 - y0];
  const size = Math.max(width, height);
  if (!(size > 1e-9 * Math.max(1, Math.abs(x0), Math.abs(y0)))) return "a single point";
  if (height < 1e-6 * size) return `on a level line ${lengthWords(width)} long`;
  if (width < 1e-6 * size) return `on an upright line ${lengthWords(height)} long`;
  return `${lengthWords(width)} wide and ${lengthWords(height)} high`;
}

function copiesWords(maps: readonly MapRow[]): string {
  const sizes = maps.map(([a, b, c, d]) => Math.sqrt(Math.abs(a * d - b * c)));
  const [least, most] = [Math.min(...sizes), Math.max(...sizes)];
  const count = maps.length === 1 ? "one copy" : `${maps.length} copies`;
  const factor = (x: number) => formatNumber(x, 3);
  if (factor(least) === factor(most))
    return maps.length === 1
      ? `${count}, ${factor(most)} as large`
      : `${count}, each ${factor(most)} as large`;
  return `${count}, from ${factor(least)} to ${factor(most)} as large`;
}

const POLYGONS: Record<number, string> = {
  3: "an equilateral triangle",
  4: "a square",
  5: "a regular pentagon",
  6: "a regular hexagon",
  8: "a regular octagon",
};

function symmetryWords({ turns, mirrors }: Symmetries): string | null {
  const polygon = POLYGONS[turns];
  if (polygon && mirrors.length >= turns) return `It has the symmetries of ${polygon}.`;
  const lines = mirrors.map((angle) =>
    angle === 90 ? "an upright line" : angle === 0 ? "a level line" : `a line at ${formatNumber(angle, 1)}°`,
  );
  const mirror = lines.length > 0 ? `is its own mirror image across ${listed(lines)}` : null;
  const rotation =
    turns === 2
      ? "looks the same upside down"
      : turns > 2
        ? `looks the same turned by ${formatNumber(360 / turns, 1)}°`
        : null;
  const both = [mirror, rotation].filter((words) => words !== null);
  return both.length > 0 ? `It ${both.join(" and ")}.` : null;
}

function piecesWords({ verdict, overlaps }: NonNullable<Described["answer"]>, looks: Looks | null): string[] {
  const pairs = overlaps.map(([i, j]) => `${i + 1} and ${j + 1}`);
  const close = verdict === "connected" ? "Copies that touch or overlap" : "Copies that come close or touch";
  const where =
    pairs.length === 0
      ? []
      : pairs.length <= MOST_PAIRS
        ? [`${close}: ${pairs.join("; ")}.`]
        : [`${close}: ${pairs.length} pairs.`];
  switch (verdict) {
    case "connected":
      return ["It is in one piece.", ...where];
    case "touching":
      return ["No gap is seen in it.", ...where];
    case "disconnected": {
      const parts = looks?.parts ?? 0;
      const many = parts > MOST_COUNTED ? `more than ${MOST_COUNTED} parts` : `${parts} parts`;
      return [parts > 1 ? `It is in pieces: a small picture shows ${many}.` : "It is in pieces.", ...where];
    }
    case "undecided":
      return ["Whether it is in one piece is not known."];
    case "no-attractor":
      return ["Its maps do not contract together: there is no shape."];
  }
}

function holesWords(holes: number): string {
  if (holes === 0) return "A small picture shows no holes.";
  if (holes > MOST_COUNTED) return `A small picture shows more than ${MOST_COUNTED} holes.`;
  return `A small picture shows ${holes === 1 ? "one hole" : `${holes} holes`}.`;
}

const listed = (words: readonly string[]): string =>
  words.length < 2 ? words.join() : `${words.slice(0, -1).join(", ")} and ${words.at(-1)}`;
