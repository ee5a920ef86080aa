import { useRef } from "preact/hooks";
import { Button } from "#ui/controls/Button";
import css from "./film.module.css";
import { useFocusIfLost } from "./focus";
import { forget, type Made, save } from "./job";
import * as messages from "./messages";
import { bytesWords, grouped, isVideo } from "./plan";

/** What was made, to look at and to save once more. */
export function Finished({ made }: { made: Made }) {
  const again = useRef<HTMLButtonElement>(null);
  useFocusIfLost(again);
  const { plan, name, blob, url, frames, missing } = made;
  const ratio = {
    aspectRatio: String(plan.width / plan.height),
    "--ratio": String(plan.width / plan.height),
  };
  return (
    <div class={css["export-running"]}>
      {isVideo(plan.kind) && (
        // biome-ignore lint/a11y/useMediaCaption: nothing is heard in it
        <video
          class={css["export-picture"]}
          src={url}
          style={ratio}
          controls
          loop
          playsInline
          aria-label={messages.film2}
        />
      )}
      {(plan.kind === "gif" || plan.kind === "apng") && (
        <img class={css["export-picture"]} src={url} style={ratio} alt={messages.film2} />
      )}
      <p class={css["export-made"]}>
        <strong>{name}</strong>
        <span class="hint">
          {bytesWords(blob.size)}
          {frames > 0 && messages.frameAside(grouped(frames))}
        </span>
      </p>
      {missing > 0 && (
        <p class="hint" role="status">
          {messages.withoutAttractor(missing)}
        </p>
      )}
      <footer class={css["export-foot"]}>
        <Button kind="quiet" onClick={forget}>
          {messages.makeAnother}
        </Button>
        <Button icon="save" buttonRef={again} onClick={() => save(made)}>
          {messages.saveAgain}
        </Button>
      </footer>
    </div>
  );
}
