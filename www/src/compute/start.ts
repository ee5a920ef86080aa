/** All jobs that follow the document, started together. */
import { scheduleCertify } from "./certify";
import type { CardChoice } from "./locus/card-trial";
import { scheduleLocus } from "./locus/schedule";
import { scheduleMatching } from "./matching";
import { schedulePlan } from "./plan";
import { scheduleProof } from "./proof";
import { scheduleRoutes } from "./routes";
import { scheduleBreaks, scheduleStrip } from "./strip";
import { scheduleThumbnails } from "./thumbnails";
import { scheduleVerdict } from "./verdict";
import { scheduleWays } from "./ways";

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
  scheduleWays();
}
