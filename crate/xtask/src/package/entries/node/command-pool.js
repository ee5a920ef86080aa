// The workers of the command, which draw and pack frames besides what those of the pool do.
import { Worker } from "node:worker_threads";
import { lanesOf, poolOn } from "../command-lanes.js";
import { like } from "./worker-like.js";

const spawn = () => like(new Worker(new URL("./command-worker.js", import.meta.url), { execArgv: [] }));

export function createPool(size) {
  const lanes = lanesOf(spawn, size);
  const asked = (name) => (args) => lanes.ask(name, args, {});
  return {
    ...poolOn(lanes),
    key: lanes.key,
    pixels: asked("pixels"),
    png: asked("png"),
    indices: asked("indices"),
  };
}
