import { computed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { verdict } from "#compute/results";
import { announce } from "#document/notice";
import { playing } from "#document/playback";
import { type VerdictWords, verdictLine, verdictWords } from "#format/verdict";
import { VerdictChip } from "#stage/evidence/Chip";
import { CHIP_ID, PANEL_ID } from "./evidence/ids";

const words = computed<VerdictWords>(() =>
  verdictWords(verdict.value?.connectedness ?? null, verdict.value?.epsilon),
);

/** What holds for the picture on the stage, in words; pressed, it tells why. */
export function MorphChip() {
  useAnnouncement();
  const stale = verdict.value?.stale ?? false;
  return <VerdictChip id={CHIP_ID} panel={PANEL_ID} stale={stale} words={words.value} />;
}

const REST_MS = 900;

/** Says the verdict aloud, but only once it has come to rest and only when it has changed. */
function useAnnouncement() {
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | null = null;
    let said = "";
    const stop = computed(() => ({
      text: verdict.value ? verdictLine(verdict.value.connectedness, verdict.value.epsilon) : "",
      moving: playing.value || verdict.value?.stale !== false,
    })).subscribe(({ text, moving }) => {
      if (timer) clearTimeout(timer);
      if (moving || text === said || !text) return;
      timer = setTimeout(() => {
        // The first is on screen with the page; only what changes is news.
        if (said) announce(text);
        said = text;
      }, REST_MS);
    });
    return () => {
      if (timer) clearTimeout(timer);
      stop();
    };
  }, []);
}
