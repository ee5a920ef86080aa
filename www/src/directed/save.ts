/** The graph-directed shapes of the document as a file. */
import { directedShapes } from "#document/directed/directed";
import { notify, wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import { answerNow, isStale } from "#stage/directed/known";
import { download, plainName } from "#ui/files/download";
import type { DirectedShape } from "#wasm/api";
import { loadExchange } from "#wasm/exchange";
import { jsonOf } from "./files";
import * as messages from "./messages";

/** Both shapes, and what stands on the stage where that is known. */
export function save(): void {
  const shapes = directedShapes.peek();
  if (!shapes) return;
  try {
    const now = isStale.peek() ? null : (answerNow.peek()?.system ?? null);
    const name = [shapes.a, shapes.b].map((shape) => plainName(shape.name, "shape", 24)).join("-");
    download(new Blob([jsonOf(scene.peek(), now)], { type: "application/json" }), `frond-${name}.json`);
  } catch (problem) {
    notify({ kind: "error", text: messages.notSaved(wordsOf(problem)) });
  }
}

/** One shape as a program of IFStile. */
export async function saveAifs({ name, states }: DirectedShape): Promise<void> {
  try {
    const { exportMaps } = await loadExchange();
    const text = exportMaps({ name, states }, "aifs");
    download(new Blob([text], { type: "text/plain" }), `frond-${plainName(name, "shape", 48)}.aifs`);
  } catch (problem) {
    notify({ kind: "error", text: messages.notSaved(wordsOf(problem)) });
  }
}
