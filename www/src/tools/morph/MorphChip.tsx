import { computed } from "@preact/signals";
import { told } from "#compute/proof";
import { verdict } from "#compute/results";
import { playing } from "#document/playback";
import { type VerdictWords, verdictLine, verdictWords } from "#format/verdict";
import { useSaidAtRest } from "#stage/evidence/aloud";
import { VerdictChip } from "#stage/evidence/Chip";
import { CHIP_ID, PANEL_ID } from "./evidence/ids";

const words = computed<VerdictWords>(() => verdictWords(told.value, verdict.value?.epsilon));

/** What holds for the picture on the stage, in words; pressed, it tells why. */
export function MorphChip() {
  useSaidAtRest(() => ({
    text: verdict.value ? verdictLine(told.value, verdict.value.epsilon) : "",
    moving: playing.value || verdict.value?.stale !== false,
  }));
  const stale = verdict.value?.stale ?? false;
  return <VerdictChip id={CHIP_ID} panel={PANEL_ID} stale={stale} words={words.value} />;
}
