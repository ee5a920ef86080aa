import { reasonWords } from "#format/reason";
import { RESOLUTION, type VerdictWords, verdictWords } from "#format/verdict";
import { VerdictSign } from "#ui/shapes/VerdictSign";
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

interface ChipProps {
  tone: VerdictWords["tone"];
  text: string;
  aside?: string;
  stale?: boolean;
}

export function Chip({ tone, text, aside = "", stale = false }: ChipProps) {
  return (
    <p class={css["verdict"]} data-stale={stale ? "" : undefined}>
      <span class={css["said"]}>
        <VerdictSign tone={tone} />
        <span>{text}</span>
      </span>
      {aside !== "" && <span class={css["verdict-aside"]}>{aside}</span>}
    </p>
  );
}
