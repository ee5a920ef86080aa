import "./verdict-sign.css";
import type { VerdictWords } from "#format/verdict";

/** A shape for each state beside its colour: one disc, two that touch, one cut in two, a ring. */
export function VerdictSign({ tone }: { tone: VerdictWords["tone"] }) {
  return (
    <svg class={`sign ${tone}`} width="1rem" height="1rem" viewBox="0 0 16 16" aria-hidden="true">
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
