/** All jobs that follow the document, started together. */
import { effect, untracked } from "@preact/signals";
import { notify, wordsOf } from "#document/notice";
import { scheduleCertify } from "./certify";
import type { CardChoice } from "./locus/card-trial";
import { scheduleLocus } from "./locus/schedule";
import { scheduleMatching } from "./matching";
import { schedulePlan } from "./plan";
import { scheduleProof } from "./proof";
import { stuck } from "./results";
import { scheduleRoutes } from "./routes";
import { scheduleBreaks, scheduleStrip } from "./strip";
import { scheduleThumbnails } from "./thumbnails";
import { scheduleVerdict } from "./verdict";

/** Ties the engine to the document: from here on every change asks for what follows from it. */
export function startSchedules(options: { card: CardChoice }): void {
  scheduleVerdict();
  scheduleLocus(options.card);
  schedulePlan();
  scheduleThumbnails();
  scheduleBreaks();
  scheduleStrip();
  scheduleCertify();
  scheduleProof();
  scheduleMatching();
  scheduleRoutes();
  // Most never need it.
  effect(() => {
    if (stuck.value)
      untracked(() => void import("./ways").then(({ scheduleWays }) => scheduleWays(), notFetched));
  });
}

function notFetched(problem: unknown): void {
  notify({ kind: "error", text: `Other ways could not be looked for: ${wordsOf(problem)}` });
}
