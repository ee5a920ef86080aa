import { keyNear } from "#document/deform/keys";
import { formatNumber } from "#format/numbers";
import type { Mesh } from "#geometry/mesh";
import type { BendFacts, Continuity, Deformation, Spin } from "#wasm/api";
import * as messages from "./messages";

/** A roughness, beside that from which on it is rough. */
export function roughnessWords(delta: number, from: number): string {
  if (delta === 0) return messages.n0OnlyLargestScale;
  return `${formatNumber(delta, 2)}, ${delta < from ? "smooth" : "rough"}`;
}

export function localityWords(kb: number, ke: number): string {
  if (kb >= ke) return messages.plainOf(formatNumber(kb, 1), formatNumber(ke, 1));
  const all = kb === 0 ? messages.scatteredOverFullShape : "";
  return messages.localityOf(formatNumber(kb, 1), formatNumber(ke, 1), all);
}

export function detailWords(ke: number): string {
  return ke === 0 ? messages.n0OnlyFullShape : messages.scalesOf(formatNumber(ke, 1));
}

export const SPINS: readonly { value: Spin; label: string; about: string }[] = [
  { value: "none", label: messages.keepsDirection, about: messages.upStaysUpIn },
  { value: "orthogonal", label: messages.rotatesWithPiece, about: messages.alsoMirroredWherePiece },
  { value: "rotation", label: messages.rotatesNeverMirrored, about: messages.onlyRotationPieceCounts },
  {
    value: "scaled",
    label: messages.rotatesAndFlattensLike,
    about: messages.wholeMapExceptSize,
  },
];

export const HOLDS: readonly { value: Continuity; label: string; about: string }[] = [
  { value: "auto", label: messages.automatic, about: messages.chosenToSuitShape },
  {
    value: "corners",
    label: messages.sharedCorners,
    about: messages.neighboursAgreeWhereTheir,
  },
  {
    value: "splat",
    label: messages.smoothingScaleByScale,
    about: messages.forPiecesTilePlane,
  },
  {
    value: "raw",
    label: messages.none,
    about: messages.partsMayComeApart,
  },
  {
    value: "published",
    label: messages.averagesAsPublished,
    about: messages.meanAllTermsOver,
  },
  {
    value: "average",
    label: messages.averagesSmoothTermsExact,
    about: messages.frondsVariantTermsShuffle,
  },
];

const CAME_TO: Record<BendFacts["continuity"], string> = {
  corners: messages.sharedCorners2,
  splat: "smoothing",
  raw: messages.noneUsed,
  average: messages.averagesWithSmoothTerms,
  published: messages.averagesAsPublished2,
};

/** What keeps the pieces together now. */
export function holdWords(asked: Continuity, got: BendFacts["continuity"] | null): string {
  if (got === null) return asked === "auto" ? "automatic" : CAME_TO[asked];
  if (asked === "auto") return messages.automaticIs(CAME_TO[got]);
  return asked === got ? CAME_TO[got] : messages.notAvailable(CAME_TO[got], CAME_TO[asked]);
}

// What is said of control points.

/** "Column 2, row 3": counted from the left and from below. */
export function nameOf({ columns }: Pick<Mesh, "columns">, index: number): string {
  return messages.columnAndRow((index % columns) + 1, Math.floor(index / columns) + 1);
}

/** "moved 0.12 right, 0.3 up". */
export function movedWords(dx: number, dy: number): string {
  const parts = [...way(dx, "right", "left"), ...way(dy, "up", "down")];
  return parts.length === 0 ? messages.atRest : messages.movedBy(parts.join(", "));
}

function way(length: number, forth: string, back: string): string[] {
  const size = Math.abs(length);
  if (!(size > 0)) return [];
  const digits = Math.max(2, Math.min(8, 1 - Math.floor(Math.log10(size))));
  return [`${formatNumber(size, digits)} ${length > 0 ? forth : back}`];
}

export function handleWords(mesh: Mesh, index: number): string {
  return `${nameOf(mesh, index)}: ${movedWords(mesh.moves[2 * index] ?? 0, mesh.moves[2 * index + 1] ?? 0)}`;
}

type Line = Pick<Deformation, "keys" | "loop" | "phase">;

export const percentWords = (at: number): string => `${formatNumber(100 * at, 1)}%`;

/** Where in time, and whether there is a key. */
export function momentWords(line: Line): string {
  const near = keyNear(line, line.phase);
  if (line.keys.length < 2) return messages.nothingMoves(percentWords(line.phase));
  const key = near < 0 ? messages.betweenKeyframes : messages.keyCount(near + 1, line.keys.length);
  return `${percentWords(line.phase)}, ${key}`;
}
