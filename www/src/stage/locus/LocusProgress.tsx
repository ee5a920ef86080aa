/** How much of a locus is worked out: from 0 to 1, where it is complete and nothing is shown. */
import * as messages from "../messages";

export function LocusProgress({ share }: { share: number }) {
  if (share >= 1) return null;
  return (
    <div
      class="locus-progress"
      role="progressbar"
      aria-label={messages.computingWhereStaysIn}
      aria-valuenow={Math.round(100 * share)}
      style={{ "--progress": String(share) }}
    />
  );
}
