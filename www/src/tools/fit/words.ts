/** What the tool says. */
import { computed, type ReadonlySignal } from "@preact/signals";
import { bytesOf, fitDocument } from "#document/fit";
import { nearestWords, percent } from "#format/nearness";
import { fixed } from "#format/numbers";
import type { ByteMethod, ByteRival, FitFigures, Method, Rival } from "#workers/fit/curve";
import { cutting } from "./stage/layers";
import { collage, shownFigures, shownFit } from "./work/fitting";
import { masked, masking, traced } from "./work/mask";
import { numbersOf, prepared } from "./work/outline";
import { cancelled, problem, running } from "./work/progress";
import { reading } from "./work/source";
import { shownWithin, withinDone } from "./work/within";

export function signed(x: number): string {
  const text = fixed(x, 3);
  return x > 0 && text !== "0.000" ? `+${text}` : text;
}

/** One line on the stage. */
export const statusWords: ReadonlySignal<string> = computed(() => {
  if (reading.value !== null) return `Reading ${reading.value} …`;
  if (cutting.value) {
    const mask = masked.value;
    if (!mask) return "Looking for the leaf …";
    if (mask.components.length === 0) return "Nothing stands out yet";
    const parts = mask.components.length === 1 ? "one part" : `${mask.components.length} parts`;
    return masking.value || !traced.value ? `${parts}, looking …` : `Cut out: ${parts}`;
  }
  if (!prepared.value) return "Waiting for an outline";
  const now = running.value;
  const spline = fitDocument.value.model === "spline";
  const best = spline ? shownWithin.value : shownFit.value;
  if (fitDocument.value.model === "collage") {
    const paper = collage.value;
    if (now || !paper) return problem.value ? "No fit" : "Fitting …";
    return `${percent(paper.fit.figures.rms)} off, ${paper.fit.numbers} numbers`;
  }
  if (now) {
    const off = now.rms === undefined || now.rms === null ? "" : `, ${percent(now.rms)} off so far`;
    return best ? `Fitting, ${Math.round(100 * now.share)}% done${off}` : "Fitting …";
  }
  if (problem.value) return "No fit";
  if (spline) return withinWords();
  const closed = shownFit.value;
  if (cancelled.value && closed?.numbers !== fitDocument.value.numbers) return "Stopped before the first fit";
  // A slider that moves has not asked for anything yet.
  if (!closed || closed.numbers !== fitDocument.value.numbers) return "Fitting …";
  const done = shownFigures.value;
  const numbers = `${numbersOf(closed.curve)} numbers`;
  if (!done?.figures) return numbers;
  return `${cancelled.value ? "Stopped: " : ""}${percent(done.figures.rms)} off, ${numbers}`;
});

/** The same of a fit within so many bytes that is not under way. */
function withinWords(): string {
  const asked = bytesOf(fitDocument.value);
  const done = withinDone.value;
  if (done?.asked !== asked) return cancelled.value ? "Stopped before the first fit" : "Fitting …";
  const bytes = `${done.bytes.toLocaleString("en-GB")} bytes`;
  if (!done.figures) return bytes;
  return `${cancelled.value ? "Stopped: " : ""}${percent(done.figures.rms)} off, ${bytes}`;
}

export const METHODS: Record<Method, { name: string; about: string }> = {
  squares: { name: "Polyline, best corners", about: "A polyline whose corners were moved by least squares" },
  split: { name: "Polyline, split", about: "A polyline through feature points" },
  bezier: { name: "Bézier curves", about: "Smooth pieces as of a tracing program" },
  fourier: { name: "Fourier descriptors", about: "The lowest frequencies of the outline" },
  collage: { name: "As in the paper", about: "Collage least squares by Cochran, Hart and Flynn" },
};

export const BYTE_METHODS: Record<ByteMethod, { name: string; about: string }> = {
  squares: {
    name: "Polyline, best corners",
    about: "Corners moved by least squares, packed in the same way",
  },
  bezier: { name: "Bézier curves", about: "Cubic pieces, counted as an ideal coder would write them" },
  fourier: { name: "Fourier descriptors", about: "The lowest frequencies, counted as an ideal coder would" },
};

/** The comparison in a sentence. */
export function compareWords(figures: FitFigures, rivals: readonly Rival[]): string {
  return nearestWords(
    figures.rms,
    rivals.map(({ method, figures }) => ({ name: METHODS[method].name, rms: figures.rms })),
  );
}

/** The same of bytes. */
export function compareBytes(rms: number, rivals: readonly ByteRival[]): string {
  return nearestWords(
    rms,
    rivals.map(({ method, rms }) => ({ name: BYTE_METHODS[method].name, rms })),
  );
}

/** How rough a fit is beside its outline: in words only where dimension and length say the same. */
export function roughWords({ fitSlope, outlineSlope, lengthRatio }: FitFigures): string {
  const d = fitSlope - outlineSlope;
  const length = `${Math.round(100 * lengthRatio)}% of its length`;
  if (Math.abs(d) <= 0.01 && Math.abs(lengthRatio - 1) <= 0.03) return "As rough as the outline.";
  if (d < 0 && lengthRatio < 1) return `Smoother than the outline: it has ${length}.`;
  if (d > 0 && lengthRatio > 1) return `Rougher than the outline: it has ${length}.`;
  return `About as rough as the outline: it has ${length}.`;
}
