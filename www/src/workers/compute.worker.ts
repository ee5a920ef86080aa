import init, * as bindings from "../../pkg/frond-proof.js";
import { executor } from "../engine/execute";
import type { Proof } from "../engine/proof";
import { type Request, type Response, toError } from "../engine/protocol";
import { adopt, frond } from "../engine/wasm";

const execute = executor({ ...frond, ...(bindings as unknown as Proof) });

function reply(response: Response, transfer: Transferable[] = []): void {
  self.postMessage(response, { transfer });
}

self.addEventListener("message", async (event: MessageEvent<Request>) => {
  const request = event.data;
  if (request.type === "start") {
    const { page, proof } = request.modules;
    await Promise.all([adopt(page), init({ module_or_path: proof })]);
    reply({ type: "ready" });
    return;
  }
  const started = performance.now();
  try {
    const { result, transfer } = await execute(request.task);
    reply({ type: "done", id: request.id, result, milliseconds: performance.now() - started }, transfer);
  } catch (problem) {
    // A trap leaves the instance in an unknown state.
    const fatal = problem instanceof WebAssembly.RuntimeError;
    reply({ type: "failed", id: request.id, error: toError(problem), fatal });
  }
});
