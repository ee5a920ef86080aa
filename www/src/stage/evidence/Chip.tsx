import { useSignalEffect } from "@preact/signals";
import type { ComponentChildren } from "preact";
import type { VerdictWords } from "#format/verdict";
import { listenForEscape } from "#ui/escape";
import { VerdictSign } from "#ui/shapes/VerdictSign";
import * as messages from "../messages";
import css from "../stage.module.css";
import { evidenceOpen } from "./shown";

interface EvidenceChipProps {
  id: string;
  /** The panel that it opens. */
  panel: string;
  stale?: boolean;
  /** What is known. */
  children: ComponentChildren;
}

/** What is known of the picture on the stage; pressed, it tells why. */
export function EvidenceChip({ id, panel, stale = false, children }: EvidenceChipProps) {
  useSignalEffect(() => {
    if (!evidenceOpen.value) return;
    return listenForEscape(() => {
      evidenceOpen.value = false;
      document.getElementById(id)?.focus();
    });
  });
  return (
    <button
      id={id}
      type="button"
      class={css["chip"]}
      title={messages.whatKnownAndWhy}
      aria-expanded={evidenceOpen.value}
      aria-controls={evidenceOpen.value ? panel : undefined}
      data-stale={stale ? "" : undefined}
      data-testid="verdict"
      onClick={() => {
        evidenceOpen.value = !evidenceOpen.peek();
      }}
    >
      {children}
    </button>
  );
}

interface VerdictChipProps extends Omit<EvidenceChipProps, "children"> {
  words: VerdictWords;
}

/** One of the four verdicts as what is known. */
export function VerdictChip({ words: { tone, text, aside }, ...chip }: VerdictChipProps) {
  return (
    <EvidenceChip {...chip}>
      <VerdictSign tone={tone} />
      <span class={css["chip-words"]}>
        <span class={css["chip-text"]}>{text}</span>
        {aside !== "" && <span class={css["chip-aside"]}>{aside}</span>}
      </span>
    </EvidenceChip>
  );
}
