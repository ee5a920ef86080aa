/** All jobs that follow the document, started together. */
import { effect, untracked } from "@preact/signals";
import { notify, wordsOf } from "#document/notice";
import { scheduleCertify } from "./certify";
import type { CardChoice } from "./locus/card/trial";
import { scheduleLocus } from "./locus/schedule";
import { scheduleMatching } from "./matching";
import * as messages from "./messages";
import { schedulePlan } from "./plan";
import { scheduleProof } from "./proof";
import { stuck } from "./results";
import { scheduleRoutes } from "./routes";
import { scheduleBreaks, scheduleStrip } from "./strip";
import { scheduleVerdict } from "./verdict";

/** Ties the engine to the document: from here on every change asks for what follows from it. */
export function startSchedules(options: { card: CardChoice }): void {
  scheduleVerdict();
  scheduleLocus(options.card);
  schedulePlan();
  scheduleBreaks();
  scheduleStrip();
  scheduleCertify();
  scheduleProof();
  scheduleMatching();
  scheduleRoutes();
  // Nobody waits for small pictures as for the large one. Without them cards have their names.
  import("./thumbnails").then(
    ({ scheduleThumbnails }) => scheduleThumbnails(),
    () => undefined,
  );
  // Most never need it.
  effect(() => {
    if (stuck.value)
      untracked(() => void import("./ways").then(({ scheduleWays }) => scheduleWays(), notFetched));
  });
}

function notFetched(problem: unknown): void {
  notify({ kind: "error", text: messages.searchFailed(wordsOf(problem)) });
}
