import { computed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { verdict } from "#compute/results";
import { announce } from "#document/notice";
import { playing } from "#document/playback";
import { type VerdictWords, verdictLine, verdictWords } from "#format/verdict";
import { evidenceOpen } from "#stage/marks";
import { CHIP_ID, PANEL_ID } from "./evidence/ids";

const words = computed<VerdictWords>(() =>
  verdictWords(verdict.value?.connectedness ?? null, verdict.value?.epsilon),
);

/** What holds for the picture on the stage, in words; pressed, it tells why. */
export function VerdictChip() {
  useAnnouncement();
  const { tone, text, aside } = words.value;
  return (
    <button
      id={CHIP_ID}
      type="button"
      class={`chip ${tone}`}
      title="What is known, and why"
      aria-expanded={evidenceOpen.value}
      aria-controls={evidenceOpen.value ? PANEL_ID : undefined}
      data-stale={verdict.value?.stale ? "" : undefined}
      data-testid="verdict"
      onClick={() => {
        evidenceOpen.value = !evidenceOpen.peek();
      }}
    >
      <Sign tone={tone} />
      <span class="chip-words">
        <span class="chip-text">{text}</span>
        {aside !== "" && <span class="chip-aside">{aside}</span>}
      </span>
    </button>
  );
}

/** A shape for each state beside its colour: whole, two that touch, broken, a question. */
function Sign({ tone }: { tone: VerdictWords["tone"] }) {
  return (
    <svg class="sign" width={16} height={16} viewBox="0 0 16 16" aria-hidden="true">
      {tone === "whole" && <circle cx={8} cy={8} r={5} />}
      {tone === "close" && (
        <path d="M8 8a3.200 3.200 0 1 0-6.400 0 3.200 3.200 0 0 0 6.400 0zm6.400 0a3.200 3.200 0 1 0-6.400 0 3.200 3.200 0 0 0 6.400 0z" />
      )}
      {tone === "broken" && (
        <>
          <path d="M7 3a5 5 0 0 0 0 10z" />
          <path d="M10 3a5 5 0 0 1 0 10z" />
        </>
      )}
      {tone === "unknown" && <circle cx={8} cy={8} r={4.25} class="hollow" />}
    </svg>
  );
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
