import { formatNumber } from "#format/numbers";
import type { BendFacts, Continuity, Spin } from "#wasm/api";

/** A roughness, beside that from which on it is rough. */
export function roughnessWords(delta: number, from: number): string {
  if (delta === 0) return "0, only the largest scale answers";
  return `${formatNumber(delta, 2)}, ${delta < from ? "smooth" : "rough"}`;
}

export function localityWords(kb: number, ke: number): string {
  if (kb >= ke) return `${formatNumber(kb, 1)} of ${formatNumber(ke, 1)}, plain`;
  const all = kb === 0 ? ", scattered over the whole" : "";
  return `${formatNumber(kb, 1)} of ${formatNumber(ke, 1)}${all}`;
}

export function detailWords(ke: number): string {
  return ke === 0 ? "0, only the whole" : `${formatNumber(ke, 1)} scales`;
}

export const SPINS: readonly { value: Spin; label: string; about: string }[] = [
  { value: "none", label: "Keeps its direction", about: "Up is up in every part." },
  { value: "orthogonal", label: "Turns with the piece", about: "And is mirrored where the piece is." },
  { value: "rotation", label: "Turns, never mirrored", about: "Only the rotation of the piece counts." },
  {
    value: "scaled",
    label: "As the piece turns and flattens",
    about: "The whole map but its size: best for ferns.",
  },
];

export const HOLDS: readonly { value: Continuity; label: string; about: string }[] = [
  { value: "auto", label: "Automatic", about: "What fits the shape." },
  {
    value: "corners",
    label: "Shared corners",
    about: "Neighbours agree where their corners meet: gaskets, squares, curves.",
  },
  {
    value: "splat",
    label: "Smoothing, scale by scale",
    about: "For pieces that tile the plane without corners, such as dragons.",
  },
  {
    value: "raw",
    label: "Nothing",
    about: "Parts may come apart, the rougher the more: for ferns and trees, whose leaves are free to sway.",
  },
  {
    value: "published",
    label: "Averages, as published",
    about:
      "The mean of all terms over each of the smallest parts, joined by triangles. Fine tips lean on their neighbours.",
  },
  {
    value: "average",
    label: "Averages, smooth terms exact",
    about: "Frond’s variant: the terms that shuffle nothing stay exact, and only the others are averaged.",
  },
];

const CAME_TO: Record<BendFacts["continuity"], string> = {
  corners: "shared corners",
  splat: "smoothing",
  raw: "nothing",
  average: "averages with the smooth terms exact",
  published: "averages as published",
};

/** What keeps the pieces together now. */
export function holdWords(asked: Continuity, got: BendFacts["continuity"] | null): string {
  if (got === null) return asked === "auto" ? "automatic" : CAME_TO[asked];
  if (asked === "auto") return `automatic: ${CAME_TO[got]}`;
  return asked === got ? CAME_TO[got] : `${CAME_TO[got]}: ${CAME_TO[asked]} cannot be had here`;
}
