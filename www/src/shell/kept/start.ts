/** Keeping, in this browser: begun after the first picture. */
import { effect } from "@preact/signals";
import { database, newId } from "#document/kept/database";
import { addressBar } from "#document/link";
import { dismiss, notify } from "#document/notice";
import { lastStep, scene } from "#document/scene";
import { tool } from "#document/tool";
import { frond } from "#wasm/core";
import { isOpen, Keeping } from "./keeping";
import * as messages from "./messages";
import { type Row, Store } from "./store";

export const store = new Store(database);

/** Of this tab alone, and there after a reload. */
const TAB = "frond.kept";

export const keeping = new Keeping(store, {
  encodeScene: (what) => frond.encodeScene(what),
  read: addressBar.read,
  claim,
  tab: {
    get() {
      try {
        return sessionStorage.getItem(TAB);
      } catch {
        return null;
      }
    },
    set(id) {
      try {
        if (id === null) sessionStorage.removeItem(TAB);
        else sessionStorage.setItem(TAB, id);
      } catch {
        // After a reload it is kept as another document.
      }
    },
  },
  newId,
  now: Date.now,
  tell: (text) => notify({ kind: "info", text: messages.notSaved(text) }),
});

/** `hash` is what the page was opened with. */
export async function beKept(hash: string): Promise<void> {
  const untouched = lastStep();
  const [visit] = performance.getEntriesByType("navigation") as PerformanceNavigationTiming[];
  const resumed = keeping.resume(hash.replace(/^#/, ""), visit?.type === "reload");
  keeping.watch();
  addEventListener("pagehide", () => void keeping.flush());
  document.addEventListener("visibilitychange", () => {
    if (document.visibilityState === "hidden") void keeping.flush();
  });
  await resumed;
  if (hash.length < 2 && !untouched) await offer();
}

/** What was made last, where nothing else was asked for. It leaves by itself: the list has it still. */
async function offer(): Promise<void> {
  // Where nothing can be read there is nothing to offer, and nobody has lost anything yet.
  const rows = await store.list().catch(() => []);
  const last = rows.filter(readable).sort((a, b) => b.time - a.time)[0];
  if (!last || lastStep() || isOpen(frond.decodeScene(last.fragment).scene)) return;
  const notice = notify({
    kind: "info",
    // Its shapes may well be those that are open: what was made of them is meant.
    text: messages.continueWith(last.name || messages.yourLastDocument),
    action: { label: messages.continueLabel, run: () => goOn(last) },
  });
  // Whoever turns to something else has answered, and what lies below it can be pressed.
  const elsewhere = ({ target }: Event) => {
    if (!(target instanceof Element && target.closest(".toast"))) end();
  };
  addEventListener("pointerdown", elsewhere, { capture: true });
  const first = tool.peek();
  const stop = effect(() => {
    scene.value;
    if (lastStep() || tool.value !== first) queueMicrotask(end);
  });
  function end() {
    dismiss(notice);
    stop();
    removeEventListener("pointerdown", elsewhere, { capture: true });
  }
}

/** Opens a document of the list, as its link would be. */
export function goOn(row: Row): void {
  keeping.await(row);
  location.hash = row.fragment;
}

/** Whether the reader of links takes it. */
export function readable({ fragment }: Row): boolean {
  try {
    return frond.decodeScene(fragment).problem === undefined;
  } catch {
    return false;
  }
}

/** A lock of the browser, which ends with the tab. */
function claim(id: string): Promise<(() => void) | null> {
  if (!navigator.locks) return Promise.resolve(null);
  return new Promise((resolve) => {
    navigator.locks
      .request(`frond-kept-${id}`, { ifAvailable: true }, (lock) =>
        lock ? new Promise<void>((release) => resolve(release)) : resolve(null),
      )
      .catch(() => resolve(null));
  });
}
