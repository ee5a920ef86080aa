// The same for Node. Idle workers do not keep a program from its end.
import { availableParallelism } from "node:os";
// biome-ignore lint/style/useNodejsImportProtocol: webpack breaks the other name where it takes the worker along.
import { Worker } from "worker_threads";
import { poolOf } from "../pool-lanes.js";

function spawn() {
  // Without what the program was started with, such as --eval.
  const worker = new Worker(new URL("./pool-worker.js", import.meta.url), { execArgv: [] });
  const like = {
    onmessage: null,
    onerror: null,
    postMessage(message, transfer) {
      if (message.type !== "stop") worker.ref();
      worker.postMessage(message, transfer);
    },
    terminate() {
      worker.terminate();
    },
  };
  worker.on("message", (data) => {
    if (data.type !== "progress") worker.unref();
    like.onmessage?.({ data });
  });
  const fail = (problem) => like.onerror?.(problem ?? {});
  worker.on("error", fail);
  worker.on("exit", () => fail());
  return like;
}

export const createPool = ({ size = availableParallelism() } = {}) => poolOf(spawn, size);
