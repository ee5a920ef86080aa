import type { ComponentChildren } from "preact";
import { IconButton } from "#ui/controls/Button";
import * as messages from "../messages";
import css from "./panel.module.css";
import { evidenceOpen } from "./shown";

interface EvidencePanelProps {
  id: string;
  /** The chip that opens it, where the focus goes when it is closed. */
  chip: string;
  title: string;
  stale?: boolean;
  children: ComponentChildren;
}

/** Why what the chip says is so; there only while it is open. */
export function EvidencePanel({ id, chip, title, stale = false, children }: EvidencePanelProps) {
  if (!evidenceOpen.value) return null;
  const close = () => {
    evidenceOpen.value = false;
    document.getElementById(chip)?.focus();
  };
  return (
    <section class={css["panel"]} id={id} aria-labelledby={`${id}-title`} data-stale={stale ? "" : undefined}>
      <header class={css["head"]}>
        <h2 id={`${id}-title`}>{title}</h2>
        <IconButton icon="close" label={messages.closeExplanation} kind="quiet" onClick={close} />
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, and keys have to reach it */}
      <div class={css["body"]} tabIndex={0}>
        {children}
      </div>
    </section>
  );
}
