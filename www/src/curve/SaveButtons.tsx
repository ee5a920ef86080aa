import { Button } from "#ui/controls/Button";
import css from "./curve.module.css";
import * as messages from "./messages";
import { KINDS, save } from "./save";

/** The curve of this moment as a file. */
export function SaveButtons() {
  return (
    <section class="stack" aria-label={messages.saveThisMoment}>
      <span class="row-name" aria-hidden="true">
        {messages.saveThisMoment}
      </span>
      <div class={css["curve-kinds"]}>
        {KINDS.map(({ kind, about }) => (
          <Button key={kind} description={about} onClick={() => save(kind)}>
            {kind.toUpperCase()}
          </Button>
        ))}
      </div>
    </section>
  );
}
