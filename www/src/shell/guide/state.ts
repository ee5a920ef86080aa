/** What is shown of the guide. */
import { signal } from "@preact/signals";
import { notify } from "#document/notice";
import { openTool } from "#document/tool";
import { help } from "#ui/commands";
import * as messages from "./messages";
import { keepSeen, keepUnderWay, seen } from "./seen";
import { STEPS } from "./steps";

/** The sentence of a first visit: to Frond, or to what somebody sent. */
export const greeting = signal<"new" | "sent" | null>(null);
/** Whether what moved by itself has arrived. */
export const rested = signal(false);
/** The step of the round that one is at; null where there is none. */
export const at = signal<number | null>(null);

/** What was sent, while the round shows something else. */
let sent = "";

/** Begins the round, or goes on where it was left. */
export function goRound(): void {
  const left = seen(STEPS.length);
  const begin = () => {
    openTool("morph");
    goTo(typeof left === "number" ? left : 0);
  };
  const wasSent = greeting.peek() === "sent";
  greeting.value = null;
  help.value = false;
  if (!wasSent || location.hash === "") {
    begin();
    return;
  }
  // Its steps are about what Frond begins with, once that is there; what was sent is one step back.
  sent = location.hash;
  addEventListener("hashchange", begin, { once: true });
  location.hash = "";
}

export function goTo(step: number): void {
  at.value = step;
  keepSeen(step);
  keepUnderWay(step);
}

/** The round is over, for now or for good. */
export function leave(step: number): void {
  at.value = null;
  keepUnderWay(null);
  if (sent !== "" && location.hash !== sent) {
    const back = sent;
    const run = () => {
      location.hash = back;
    };
    notify({
      kind: "info",
      text: messages.tourOver,
      action: { label: messages.backToSharedLink, run },
    });
  }
  sent = "";
  keepSeen(step > 0 && step < STEPS.length - 1 ? step : "seen");
}

export function greeted(): void {
  greeting.value = null;
  keepSeen("seen");
}
