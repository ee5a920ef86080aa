/** What a shape looks like, for those who do not see it. */
import type { Looks } from "#geometry/holes";
import type { Symmetries } from "#geometry/maps/symmetries";
import type { Connectedness, MapRow } from "#wasm/api";
import * as messages from "./messages";
import { formatNumber } from "./numbers";
import { listWords } from "./path-words";
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
  const said = [messages.shapeIs(name, copiesWords(maps), box ? messages.sizeAside(sizeWords(box)) : "")];
  const symmetry = symmetryWords(symmetries);
  if (symmetry) said.push(symmetry);
  if (answer) said.push(...piecesWords(answer, looks));
  if (looks && looks.parts > 0) said.push(holesWords(looks.holes));
  return said.join(" ");
}

export function sizeWords({ x0, y0, x1, y1 }: NonNullable<Described["box"]>): string {
  const [width, height] = [x1 - x0, y1 - y0];
  const size = Math.max(width, height);
  if (!(size > 1e-9 * Math.max(1, Math.abs(x0), Math.abs(y0)))) return messages.singlePoint;
  if (height < 1e-6 * size) return messages.onHorizontal(lengthWords(width));
  if (width < 1e-6 * size) return messages.onVertical(lengthWords(height));
  return messages.widthAndHeight(lengthWords(width), lengthWords(height));
}

function copiesWords(maps: readonly MapRow[]): string {
  const sizes = maps.map(([a, b, c, d]) => Math.sqrt(Math.abs(a * d - b * c)));
  const [least, most] = [Math.min(...sizes), Math.max(...sizes)];
  const count = messages.copies(maps.length);
  const factor = (x: number) => formatNumber(x, 3);
  if (factor(least) === factor(most))
    return maps.length === 1 ? messages.oneSize(count, factor(most)) : messages.eachSize(count, factor(most));
  return messages.sizesBetween(count, factor(least), factor(most));
}

const POLYGONS: Record<number, string> = {
  3: messages.equilateralTriangle,
  4: messages.square,
  5: messages.regularPentagon,
  6: messages.regularHexagon,
  8: messages.regularOctagon,
};

function symmetryWords({ turns, mirrors }: Symmetries): string | null {
  const polygon = POLYGONS[turns];
  if (polygon && mirrors.length >= turns) return messages.hasSymmetries(polygon);
  const lines = mirrors.map((angle) =>
    angle === 90
      ? messages.verticalLine
      : angle === 0
        ? messages.horizontalLine
        : messages.lineAt(formatNumber(angle, 1)),
  );
  const mirror = lines.length > 0 ? messages.mirrored(listWords(lines)) : null;
  const rotation =
    turns === 2
      ? messages.looksSameUpsideDown
      : turns > 2
        ? messages.rotated(formatNumber(360 / turns, 1))
        : null;
  const both = [mirror, rotation].filter((words) => words !== null);
  return both.length > 0 ? messages.itDoes(listWords(both)) : null;
}

function piecesWords({ verdict, overlaps }: NonNullable<Described["answer"]>, looks: Looks | null): string[] {
  const pairs = overlaps.map(([i, j]) => messages.pair(i + 1, j + 1));
  const close = verdict === "connected" ? messages.copiesTouchOrOverlap : messages.copiesComeCloseOr;
  const where =
    pairs.length === 0
      ? []
      : pairs.length <= MOST_PAIRS
        ? [messages.pairsAre(close, pairs.join("; "))]
        : [messages.pairCount(close, pairs.length)];
  switch (verdict) {
    case "connected":
      return [messages.inOnePiece, ...where];
    case "touching":
      return [messages.noGapVisible, ...where];
    case "disconnected": {
      const parts = looks?.parts ?? 0;
      const many = parts > MOST_COUNTED ? messages.moreParts(MOST_COUNTED) : messages.parts(parts);
      return [parts > 1 ? messages.inPieces(many) : messages.inPiecesOnly, ...where];
    }
    case "undecided":
      return [messages.notKnownWhetherIn];
    case "no-attractor":
      return [messages.mapsDoNotContract];
  }
}

function holesWords(holes: number): string {
  if (holes === 0) return messages.smallPictureShowsNo;
  if (holes > MOST_COUNTED) return messages.moreHoles(MOST_COUNTED);
  return messages.someHoles(holes);
}
