import { useRef } from "preact/hooks";
import { Button } from "#ui/controls/Button";
import css from "./film.module.css";
import { useFocusIfLost } from "./focus";
import { forget, type Made, save } from "./job";
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
          aria-label="The film"
        />
      )}
      {(plan.kind === "gif" || plan.kind === "apng") && (
        <img class={css["export-picture"]} src={url} style={ratio} alt="The film" />
      )}
      <p class={css["export-made"]}>
        <strong>{name}</strong>
        <span class="hint">
          {bytesWords(blob.size)}
          {frames > 0 && `, ${grouped(frames)} frames`}
        </span>
      </p>
      {missing > 0 && (
        <p class="hint" role="status">
          {grouped(missing)} {missing === 1 ? "moment has" : "moments have"} no attractor: there the frame
          before stands still.
        </p>
      )}
      <footer class={css["export-foot"]}>
        <Button kind="quiet" onClick={forget}>
          Make another
        </Button>
        <Button icon="save" buttonRef={again} onClick={() => save(made)}>
          Save again
        </Button>
      </footer>
    </div>
  );
}
