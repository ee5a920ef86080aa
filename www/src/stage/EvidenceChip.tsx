import { useSignalEffect } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { listenForEscape } from "#ui/escape";
import { evidenceOpen } from "./evidence-shown";
import css from "./stage.module.css";

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
      title="What is known, and why"
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
