// Functions of the package that take their time, in workers of its own.
import { poolOf } from "./pool-lanes.js";

// Named here, so that bundlers, which take the worker along where it is started, do not take it twice.
const here = import.meta.url;

function spawn() {
  try {
    return new Worker(new URL("./pool-worker.js", import.meta.url), { type: "module", name: "frond" });
  } catch (problem) {
    if (problem?.name !== "SecurityError") throw problem;
    // A page of another origin may import the script, but not start a worker from it.
    const script = new URL("./pool-worker.js", here).href;
    const blob = new Blob([`import ${JSON.stringify(script)};`], { type: "text/javascript" });
    return new Worker(URL.createObjectURL(blob), { type: "module", name: "frond" });
  }
}

export const createPool = ({ size = navigator.hardwareConcurrency || 2 } = {}) => poolOf(spawn, size);
