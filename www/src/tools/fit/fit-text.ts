/** What the tool says. */
import { computed, type ReadonlySignal } from "@preact/signals";
import { bytesOf, fitDocument } from "#document/fit";
import { nearestWords, percent } from "#format/nearness";
import { fixed } from "#format/numbers";
import type { ByteMethod, ByteRival, FitFigures, Method, Rival } from "#workers/fit/curve";
import * as messages from "./messages";
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
  if (reading.value !== null) return messages.readingOf(reading.value);
  if (cutting.value) {
    const mask = masked.value;
    if (!mask) return messages.findingLeaf;
    if (mask.components.length === 0) return messages.nothingStandsOutYet;
    const parts =
      mask.components.length === 1 ? messages.onePart : messages.partCount(mask.components.length);
    return masking.value || !traced.value ? messages.partsSearching(parts) : messages.cutOutOf(parts);
  }
  if (!prepared.value) return messages.waitingForOutline;
  const now = running.value;
  const spline = fitDocument.value.model === "spline";
  const best = spline ? shownWithin.value : shownFit.value;
  if (fitDocument.value.model === "collage") {
    const paper = collage.value;
    if (now || !paper) return problem.value ? messages.noFit : messages.fitting;
    return messages.errorAndNumbers(percent(paper.fit.figures.rms), paper.fit.numbers);
  }
  if (now) {
    const off = now.rms === undefined || now.rms === null ? "" : messages.errorSoFar(percent(now.rms));
    return best ? messages.fittingPercent(Math.round(100 * now.share), off) : messages.fitting;
  }
  if (problem.value) return messages.noFit;
  if (spline) return withinWords();
  const closed = shownFit.value;
  if (cancelled.value && closed?.numbers !== fitDocument.value.numbers) return messages.stoppedBeforeFirstFit;
  // A slider that moves has not asked for anything yet.
  if (!closed || closed.numbers !== fitDocument.value.numbers) return messages.fitting;
  const done = shownFigures.value;
  const numbers = messages.numbersOf(numbersOf(closed.curve));
  if (!done?.figures) return numbers;
  return (cancelled.value ? messages.stoppedAt : messages.errorAndAmount)(percent(done.figures.rms), numbers);
});

/** The same of a fit within so many bytes that is not under way. */
function withinWords(): string {
  const asked = bytesOf(fitDocument.value);
  const done = withinDone.value;
  if (done?.asked !== asked) return cancelled.value ? messages.stoppedBeforeFirstFit : messages.fitting;
  const bytes = messages.bytes(done.bytes.toLocaleString("en-GB"));
  if (!done.figures) return bytes;
  return (cancelled.value ? messages.stoppedAt : messages.errorAndAmount)(percent(done.figures.rms), bytes);
}

export const METHODS: Record<Method, { name: string; about: string }> = {
  squares: { name: messages.polylineBestCorners, about: messages.polylineWhoseCornersWere },
  split: { name: messages.polylineSplit, about: messages.polylineThroughFeaturePoints },
  bezier: { name: messages.bezierCurves, about: messages.smoothPiecesAsFrom },
  fourier: { name: messages.fourierDescriptors, about: messages.lowestFrequenciesOutline },
  collage: { name: messages.asInPaper, about: messages.collageLeastSquaresBy },
};

export const BYTE_METHODS: Record<ByteMethod, { name: string; about: string }> = {
  squares: {
    name: messages.polylineBestCorners,
    about: messages.cornersAdjustedByLeast,
  },
  bezier: { name: messages.bezierCurves, about: messages.cubicPiecesCountedAs },
  fourier: { name: messages.fourierDescriptors, about: messages.lowestFrequenciesCountedAs },
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
  const length = messages.percentOfPerimeter(Math.round(100 * lengthRatio));
  if (Math.abs(d) <= 0.01 && Math.abs(lengthRatio - 1) <= 0.03) return messages.asRoughAsOutline;
  if (d < 0 && lengthRatio < 1) return messages.smoother(length);
  if (d > 0 && lengthRatio > 1) return messages.rougher(length);
  return messages.sameRoughness(length);
}
