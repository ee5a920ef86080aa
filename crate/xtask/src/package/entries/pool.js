// Functions of the package that take their time, in workers of its own.
import { poolOf } from "./pool-lanes.js";

export { FrondError } from "./guard.js";

// Named here, so that bundlers, which take the worker along where it is started, do not take it twice.
const here = import.meta.url;

// Bundlers look for these very words.
const start = () =>
  new Worker(new URL("./pool-worker.js", import.meta.url), { type: "module", name: "frond" });

function spawn() {
  try {
    // First of all: where the page requires it, each attempt without is an error in its console.
    return globalThis.trustedTypes ? startTrusted() : start();
  } catch (problem) {
    if (problem?.name !== "SecurityError") throw problem;
    // A page of another origin may import the script, but not start a worker from it.
    const script = new URL("./pool-worker.js", here).href;
    const blob = new Blob([`import ${JSON.stringify(script)};`], { type: "text/javascript" });
    return new Worker(trusted(URL.createObjectURL(blob)), { type: "module", name: "frond" });
  }
}

let policy;

/** Under `require-trusted-types-for 'script'` the page lets in the policy `frond-pool`. */
function trusted(address) {
  policy ??= made();
  return policy ? policy.createScriptURL(address) : address;
}

/** Null where there are none, and where the page refuses the name: it may take addresses all the same. */
function made() {
  try {
    return (
      globalThis.trustedTypes?.createPolicy("frond-pool", { createScriptURL: (script) => script }) ?? null
    );
  } catch {
    return null;
  }
}

/** Only a bundler knows the address of the worker: it is taken on its way to the browser, for as long as one call. */
function startTrusted() {
  const Plain = globalThis.Worker;
  globalThis.Worker = class extends Plain {
    constructor(address, options) {
      super(trusted(String(address)), options);
    }
  };
  try {
    return start();
  } finally {
    globalThis.Worker = Plain;
  }
}

export const createPool = ({ size = navigator.hardwareConcurrency || 2 } = {}) => poolOf(spawn, size);
