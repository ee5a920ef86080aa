import "#ui/panel/progress.css";
import { useRef } from "preact/hooks";
import { Button } from "#ui/controls/Button";
import css from "./film.module.css";
import { useFocusIfLost } from "./focus";
import { cancel, type Job } from "./job";
import { Picture } from "./Preview";
import { grouped, isFilm, timeWords } from "./plan";

/** How far it is, what was drawn last, and a way to end it. */
export function Running({ job }: { job: Job }) {
  const button = useRef<HTMLButtonElement>(null);
  useFocusIfLost(button);
  const { plan, done, of, left, preview } = job;
  const words =
    done === 0
      ? "Getting ready …"
      : `${grouped(done)} of ${grouped(of)} frames${left === null ? "" : `, about ${timeWords(left)} left`}`;
  return (
    <div class={css["export-running"]}>
      {isFilm(plan.kind) && (
        <Picture
          image={preview}
          label={preview ? `Frame ${done}` : "No frame yet"}
          ratio={plan.width / plan.height}
        />
      )}
      <progress class="progress" max={of} value={done} aria-label="Frames made" />
      <footer class={css["export-foot"]}>
        <p class="hint number">{words}</p>
        <Button buttonRef={button} onClick={cancel}>
          Cancel
        </Button>
      </footer>
    </div>
  );
}
