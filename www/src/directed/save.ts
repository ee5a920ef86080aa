/** The graph-directed shapes of the document as a file. */
import { directedShapes } from "#document/directed/directed";
import { notify, wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import { answerNow, isStale } from "#stage/directed/known";
import { download, plainName } from "#ui/files/download";
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
