// A worker of the command.
import { parentPort } from "node:worker_threads";
import { performerFrom } from "../command-lanes.js";
import { started } from "./modules.js";

const perform = performerFrom({
  draw: () => started(import("./draw.js")),
  proof: () => started(import("./proof.js")),
  fit: () => started(import("./fit.js")),
  space: () => started(import("./space.js")),
  directed: () => started(import("./directed.js")),
})((answer, transfer) => parentPort.postMessage(answer, transfer));

parentPort.on("message", (data) => perform(data));
