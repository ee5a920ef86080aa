/** Frond at home: off line, told of newer versions, and opening files that the system hands to it. */
import { notify } from "#document/notice";
import { openFile } from "#ui/files/door";
import * as messages from "./messages";

/** What an installed page is given by the system, where there is such a thing. */
interface LaunchQueue {
  setConsumer(take: (launch: { files: readonly { getFile(): Promise<File> }[] }) => void): void;
}

/** Long enough for what is fetched ahead. */
const SETTLED_MS = 4000;

export function beInstalled(): void {
  const { launchQueue } = window as { launchQueue?: LaunchQueue };
  launchQueue?.setConsumer(({ files }) => {
    Promise.all(files.map((file) => file.getFile())).then(
      ([first, ...others]) => first && openFile([first, ...others]),
      () => notify({ kind: "error", text: messages.fileCouldNotRead }),
    );
  });
  const workers = import.meta.env.DEV ? null : serviceWorkers();
  if (!workers) return;
  const before = workers.controller;
  workers.addEventListener("controllerchange", () => {
    // The first one is no news.
    if (before) tellOfUpdate();
  });
  // Without it everything works, but off line: private windows and old browsers have none.
  workers.register("./sw.js").then(
    () => setTimeout(() => keepLoaded(workers), SETTLED_MS),
    () => undefined,
  );
}

/** Null where there are none: in a sandboxed frame even to ask for them throws. */
function serviceWorkers(): ServiceWorkerContainer | null {
  try {
    return navigator.serviceWorker ?? null;
  } catch {
    return null;
  }
}

/** The document stands in the address, which loading again brings back. */
function tellOfUpdate(): void {
  notify({
    kind: "info",
    text: messages.newerVersionFrondAvailable,
    stays: true,
    action: { label: messages.update, run: () => location.reload() },
  });
}

/** What was loaded before there was a worker is kept as well. */
async function keepLoaded(workers: ServiceWorkerContainer): Promise<void> {
  const { active } = await workers.ready;
  const loaded = performance.getEntriesByType("resource").map(({ name }) => name);
  active?.postMessage({ keep: [location.href, ...loaded] });
}
