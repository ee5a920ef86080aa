import { formatNumber } from "#format/numbers";
import type { BendFacts, Continuity, Spin } from "#wasm/api";
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
