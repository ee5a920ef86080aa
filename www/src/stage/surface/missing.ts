import { notify, wordsOf } from "#document/notice";

/** Tells why there is no renderer, and what brings it back. */
export function explainMissing(problem: unknown): void {
  const missing = (problem as { code?: unknown } | null)?.code === "no-gpu";
  notify({
    kind: "info",
    text: missing
      ? "The graphics card is not available, so the processor draws the picture. To use the card, switch on hardware acceleration in the browser's settings."
      : `The renderer could not be loaded (${wordsOf(problem)}), so the processor draws the picture. Reload the page to try again.`,
  });
}
