import { scheduleLocus } from "./locus";
import { adoptPath, schedulePlan } from "./plan";
import { scheduleBreaks, scheduleStrip } from "./strip";
import { scheduleThumbnails } from "./thumbnails";
import { scheduleVerdict } from "./verdict";

export { adoptPath } from "./plan";

/** Ties the engine to the document: from here on every change asks for what follows from it. */
export function startSchedules(): void {
  adoptPath();
  scheduleVerdict();
  scheduleLocus();
  schedulePlan();
  scheduleThumbnails();
  scheduleBreaks();
  scheduleStrip();
}
