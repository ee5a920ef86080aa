import { reasonWords } from "#format/reason";
import { type VerdictWords, verdictWords } from "#format/verdict";
import { judged } from "./work";

/** Whether what is seen is in one piece, in words; and why, where there is a reason. */
export function Holds() {
  const now = judged.value;
  const words = verdictWords(now?.answer ?? null);
  const reason = now?.answer.reason;
  return (
    <div class="morph3-holds">
      <p
        class={`morph3-verdict ${words.tone}`}
        data-stale={now?.stale ? "" : undefined}
        data-testid="space-verdict"
      >
        <Sign tone={words.tone} />
        <strong>{words.text}</strong>
        {words.aside !== "" && <span class="dim">{words.aside}</span>}
      </p>
      {reason && (
        <details class="morph3-why">
          <summary>Why</summary>
          <p class="hint">{reasonWords(reason)}</p>
        </details>
      )}
    </div>
  );
}

/** A shape for each state beside its colour: whole, two that touch, broken, a question. */
function Sign({ tone }: { tone: VerdictWords["tone"] }) {
  return (
    <svg width={16} height={16} viewBox="0 0 16 16" aria-hidden="true">
      {tone === "whole" && <circle cx={8} cy={8} r={5} />}
      {tone === "close" && (
        <>
          <circle cx={4.8} cy={8} r={3.2} />
          <circle cx={11.2} cy={8} r={3.2} />
        </>
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
