import { reasonWords } from "#format/reason";
import { verdictWords } from "#format/verdict";
import { VerdictSign } from "#ui/shapes/VerdictSign";
import * as messages from "../messages";
import css from "./morph3.module.css";
import { judged } from "./work";

/** Whether what is seen is in one piece, in words; and why, where there is a reason. */
export function Holds() {
  const now = judged.value;
  const words = verdictWords(now?.answer ?? null);
  const reason = now?.answer.reason;
  return (
    <div class={css["morph3-holds"]}>
      <p class={css["morph3-verdict"]} data-stale={now?.stale ? "" : undefined} data-testid="space-verdict">
        <VerdictSign tone={words.tone} />
        <strong>{words.text}</strong>
        {words.aside !== "" && <span class="dim">{words.aside}</span>}
      </p>
      {reason && (
        <details class={css["morph3-why"]}>
          <summary>{messages.why}</summary>
          <p class="hint">{reasonWords(reason)}</p>
        </details>
      )}
    </div>
  );
}
