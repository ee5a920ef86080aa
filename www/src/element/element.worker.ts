/** Draws for the elements of a page, off its thread. */
import { initSync } from "../../pkg/frond-morph.js";
import { type FromWorker, failureOf, type ToWorker } from "./protocol";
import { work } from "./work";

addEventListener("message", async ({ data }: MessageEvent<ToWorker>) => {
  if ("module" in data) {
    initSync({ module: data.module });
    return;
  }
  const say = (answer: FromWorker, transfer: Transferable[] = []) => postMessage(answer, { transfer });
  try {
    const result = await work(data.job);
    say({ result }, result instanceof Uint8ClampedArray ? [result.buffer] : []);
  } catch (problem) {
    say({ failure: failureOf(problem) });
  }
});
