/** Workers of a sandboxed frame. */

/** What was said before the worker was there is said again. */
const RELAY = `const early = [];
const hold = (event) => early.push(event);
addEventListener("message", hold);
import(ADDRESS).then(
  () => {
    removeEventListener("message", hold);
    for (const { data, ports } of early) dispatchEvent(new MessageEvent("message", { data, ports }));
  },
  (problem) => setTimeout(() => { throw problem; }),
);`;

/**
 * Such a frame has no origin, and may start no worker from an address, nor a module from a text of its own. A plain
 * text may import what is at the address, where the host allows it.
 */
export function allowWorkers(): void {
  const Plain = Worker;
  globalThis.Worker = class extends Plain {
    constructor(address: string | URL, { name = "" }: WorkerOptions = {}) {
      const text = RELAY.replace("ADDRESS", JSON.stringify(new URL(address, location.href).href));
      super(URL.createObjectURL(new Blob([text], { type: "text/javascript" })), { name });
    }
  };
}
