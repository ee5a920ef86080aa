/** A worker of the plane: it starts the modules and does one task after the other. */
import { adopt, frond } from "#wasm/core";
import { toError } from "#wasm/error";
import init, * as bindings from "../../../pkg/frond-proof.js";
import { executor } from "./tasks";
import type { Request, Response } from "./protocol";

/** The task under way, and whether its answer is still wanted. */
let current = 0;
let stopped = false;

async function breathe(): Promise<void> {
  reply({ type: "alive", id: current });
  // Word that it is to stop comes as a message: after this.
  await new Promise((resolve) => setTimeout(resolve));
  if (stopped) throw { code: "stopped", message: "Something else was asked for." };
}

const execute = executor({ ...frond, ...bindings }, breathe);

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
  if (request.type === "stop") {
    stopped ||= request.id === current;
    return;
  }
  current = request.id;
  stopped = false;
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
