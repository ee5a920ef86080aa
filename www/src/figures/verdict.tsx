import type { Connectedness } from "../engine/api";
import { reasonWords } from "../state/reason";
import { lengthWords, verdictWords } from "../state/words";

/** A verdict as one line of text, for labels and tips. */
export function verdictLine(answer: Connectedness | null): string {
  if (answer === null) return "being looked at";
  const { text, aside } = verdictWords(answer);
  return `${text}, ${aside}`;
}

export function isBrokenVerdict(answer: Connectedness | null): boolean {
  return answer?.verdict === "disconnected" || answer?.verdict === "no-attractor";
}

type Tone = "whole" | "close" | "broken" | "unknown";

/** What holds, in words and with a sign; `stale` while it is still about the moment before. */
export function VerdictChip({ answer, stale = false }: { answer: Connectedness | null; stale?: boolean }) {
  const words = answer === null ? null : verdictWords(answer);
  return (
    <Chip
      tone={words?.tone ?? "unknown"}
      text={words?.text ?? "Looking …"}
      aside={words?.aside ?? ""}
      stale={stale}
    />
  );
}

/** The same asked at a millionth of the shape's size: no screen is spoken of. */
export function ExactChip({ answer, stale = false }: { answer: Connectedness | null; stale?: boolean }) {
  return <Chip {...exactWords(answer)} stale={stale} />;
}

export function exactWords(answer: Connectedness | null): { tone: Tone; text: string; aside: string } {
  switch (answer?.verdict) {
    case undefined:
      return { tone: "unknown", text: "Looking …", aside: "" };
    case "connected":
      return { tone: "whole", text: "In one piece", aside: "proved" };
    case "touching":
      return { tone: "close", text: "Touching", aside: "to a millionth of its size" };
    case "disconnected":
      return {
        tone: "broken",
        text: "In pieces",
        aside: `proved, with a gap of ${lengthWords(answer.gap.upper)}`,
      };
    default:
      return { tone: "unknown", text: "Undecided", aside: "" };
  }
}

/** The reason of a proof that a shape is in one piece, where there is one. */
export function Why({ answer }: { answer: Connectedness | undefined }) {
  const reason = answer?.verdict === "connected" ? answer.reason : undefined;
  return reason ? <p class="why">{reasonWords(reason.text)}</p> : null;
}

export interface ChipProps {
  tone: Tone;
  text: string;
  aside?: string;
  stale?: boolean;
}

export function Chip({ tone, text, aside = "", stale = false }: ChipProps) {
  return (
    <p class={`verdict ${tone}`} data-stale={stale ? "" : undefined}>
      <Sign tone={tone} />
      <span class="verdict-text">{text}</span>
      {aside !== "" && <span class="verdict-aside">{aside}</span>}
    </p>
  );
}

/** A shape for each state beside its colour: one disc, two that touch, one cut in two, a ring. */
export function Sign({ tone }: { tone: Tone }) {
  return (
    <svg class={`verdict-sign ${tone}`} width={16} height={16} viewBox="0 0 16 16" aria-hidden="true">
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
