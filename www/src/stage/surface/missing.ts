import { notify, wordsOf } from "#document/notice";

/** Tells why there is no renderer, and what brings it back. */
export function explainMissing(problem: unknown): void {
  const missing = (problem as { code?: unknown } | null)?.code === "no-gpu";
  notify({
    kind: "info",
    text: missing
      ? "The graphics card is not available, so that the picture is computed without it, slower. Switching on hardware acceleration in the browser's settings brings it back."
      : `The renderer could not be loaded (${wordsOf(problem)}), so that the picture is computed without it, slower. Reloading the page tries again.`,
  });
}
