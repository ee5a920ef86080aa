import "#ui/panel/progress.css";
import { useRef } from "preact/hooks";
import { Button } from "#ui/controls/Button";
import css from "./film.module.css";
import { useFocusIfLost } from "./focus";
import { cancel, type Job } from "./job";
import * as messages from "./messages";
import { Picture } from "./Preview";
import { grouped, isFilm, timeWords } from "./plan";

/** How far it is, what was drawn last, and a way to end it. */
export function Running({ job }: { job: Job }) {
  const button = useRef<HTMLButtonElement>(null);
  useFocusIfLost(button);
  const { plan, done, of, left, preview } = job;
  const words =
    done === 0
      ? messages.preparing
      : left === null
        ? messages.framesDone(grouped(done), grouped(of))
        : messages.framesDoneLeft(grouped(done), grouped(of), timeWords(left));
  return (
    <div class={css["export-running"]}>
      {isFilm(plan.kind) && (
        <Picture
          image={preview}
          label={preview ? messages.frameNumber(done) : messages.noFrameYet}
          ratio={plan.width / plan.height}
        />
      )}
      <progress class="progress" max={of} value={done} aria-label={messages.framesRendered} />
      <footer class={css["export-foot"]}>
        <p class="hint number">{words}</p>
        <Button buttonRef={button} onClick={cancel}>
          {messages.cancel}
        </Button>
      </footer>
    </div>
  );
}
