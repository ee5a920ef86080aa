import { notify, wordsOf } from "#document/notice";
import * as messages from "../messages";

/** Tells why there is no renderer, and what brings it back. */
export function explainMissing(problem: unknown): void {
  const missing = (problem as { code?: unknown } | null)?.code === "no-gpu";
  notify({
    kind: "info",
    text: missing ? messages.graphicsCardNotAvailable : messages.rendererMissing(wordsOf(problem)),
  });
}
