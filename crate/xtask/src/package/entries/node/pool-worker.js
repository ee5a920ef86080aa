// A worker of the pool in Node.
import { parentPort } from "node:worker_threads";
import { performerFrom } from "../pool-lanes.js";

const started = async (loading) => {
  const module = await loading;
  await module.default();
  return module;
};

const perform = performerFrom({
  draw: () => started(import("./draw.js")),
  proof: () => started(import("./proof.js")),
  fit: () => started(import("./fit.js")),
  space: () => started(import("./space.js")),
})((answer, transfer) => parentPort.postMessage(answer, transfer));

parentPort.on("message", (data) => perform(data));
