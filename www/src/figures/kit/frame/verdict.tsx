import { reasonWords } from "#format/reason";
import { RESOLUTION, type VerdictWords, verdictWords } from "#format/verdict";
import type { Connectedness } from "#wasm/api";
import layout from "./layout.module.css";
import css from "./verdict.module.css";

/** Whether it is proved to be in pieces, or has no attractor. */
export function isBrokenVerdict(answer: Connectedness | null): boolean {
  return answer?.verdict === "disconnected" || answer?.verdict === "no-attractor";
}

/** A millionth of the diameter: no screen is spoken of. */
export const EXACT = 1e-6;

interface VerdictChipProps {
  answer: Connectedness | null;
  /** What it was looked at with. */
  epsilon?: number;
  stale?: boolean;
}

/** What holds, in words and with a sign; `stale` while it is still about the moment before. */
export function VerdictChip({ answer, epsilon = RESOLUTION, stale = false }: VerdictChipProps) {
  return <Chip {...verdictWords(answer, epsilon)} stale={stale} />;
}

/** The reason of a proof that a shape is in one piece, where there is one. */
export function Why({ answer }: { answer: Connectedness | undefined }) {
  const reason = answer?.verdict === "connected" ? answer.reason : undefined;
  return reason ? <p class={layout["why"]}>{reasonWords(reason.text)}</p> : null;
}

export interface ChipProps {
  tone: VerdictWords["tone"];
  text: string;
  aside?: string;
  stale?: boolean;
}

export function Chip({ tone, text, aside = "", stale = false }: ChipProps) {
  return (
    <p class={css["verdict"]} data-stale={stale ? "" : undefined}>
      <Sign tone={tone} />
      <span>{text}</span>
      {aside !== "" && <span class={css["verdict-aside"]}>{aside}</span>}
    </p>
  );
}

/** A shape for each state beside its colour: one disc, two that touch, one cut in two, a ring. */
export function Sign({ tone }: { tone: VerdictWords["tone"] }) {
  return (
    <svg
      class={`${css["verdict-sign"]} ${css[tone] ?? ""}`}
      width={16}
      height={16}
      viewBox="0 0 16 16"
      aria-hidden="true"
    >
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
      {tone === "unknown" && <circle cx={8} cy={8} r={4.25} class={css["hollow"]} />}
    </svg>
  );
}
