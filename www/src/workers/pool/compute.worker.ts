/** A worker of the plane. */
import { adopt } from "#wasm/core";
import init, * as proof from "../../../pkg/frond-proof.js";
import { performerOf } from "../lanes/performer";
import type { Ask } from "../lanes/task";
import type { Modules } from "./protocol";
import { tasks, tools } from "./tasks";

const start = async (modules: Modules) => {
  await Promise.all([adopt(modules.page), init({ module_or_path: modules.proof })]);
  return tools(proof);
};

// Its slices are short.
const perform = performerOf(tasks, start, true)((answer, transfer) => self.postMessage(answer, { transfer }));

self.addEventListener("message", (event: MessageEvent<Ask<Modules>>) => perform(event.data));
