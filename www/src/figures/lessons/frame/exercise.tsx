import type { ComponentChildren } from "preact";
import { useContext, useEffect } from "preact/hooks";
import { Button } from "#ui/controls/Button";
import { Icon } from "#ui/controls/Icon";
import { useOwnId } from "#ui/id";
import frameCss from "../../kit/frame/frame.module.css";
import layout from "../../kit/frame/layout.module.css";
import { CopyLink } from "../../kit/state/copy-link";
import { useAfresh } from "../../kit/state/kept";
import { useValue } from "../../kit/workers";
import { done, markDone } from "./done";
import css from "./exercise.module.css";
import { Room, Squares } from "./handout/room";
import { LessonId, OnPaper } from "./lesson-id";
import { slide } from "./slides/on-slides";

interface ExerciseProps {
  /** Its place among the exercises of the lesson, from 1. */
  number: number;
  ask: ComponentChildren;
  /** From a nudge to nearly all; one is shown at a time. */
  hints: readonly string[];
  /** Whether what stands there now is a solution; null while it is being found out. */
  solved: boolean | null;
  /** How far it is, in words. */
  status: ComponentChildren;
  /** Pictures and controls. */
  children: ComponentChildren;
}

/**
 * Something to be made, which the program can check. Once solved it stays marked, whatever is tried after; the mark
 * says whether what stands there now is a solution.
 */
export function Exercise({ number, ask, hints, solved, status, children }: ExerciseProps) {
  const lesson = useContext(LessonId);
  const written = useContext(OnPaper)[number - 1] ?? "same";
  const drawn = written !== "same" && written.space === "squares";
  const name = `${lesson}.${number}`;
  const [told, setTold] = useAfresh("hints", 0, 0);
  const heading = useOwnId("exercise");
  // On slides it is a class that solves it, and not who has solved it in this browser.
  const own = useValue(slide) === null;
  const was = useValue(done).has(name) && own;
  useEffect(() => {
    if (solved && own) markDone(name);
  }, [solved, own, name]);
  return (
    <section
      class={frameCss["figure-live"]}
      data-testid="exercise"
      data-step={`exercise-${number}`}
      data-paper={written === "same" ? undefined : (written.space ?? "lines")}
      aria-labelledby={heading}
    >
      <div class={frameCss["step-head"]}>
        <h3 id={heading} class={css["name"]}>
          Exercise {number}
          {was && (
            <span class={css["was"]} data-now={solved ? "" : undefined}>
              <Icon name="check" size={16} /> {solved ? "solved" : "solved before"}
            </span>
          )}
        </h3>
        <CopyLink step={`exercise-${number}`} />
      </div>
      <p class={css["ask"]} data-screen={written === "same" ? undefined : ""}>
        {ask}
      </p>
      {written !== "same" && (
        <p class={`${css["ask"]} ${css["on-paper"]}`} aria-hidden="true">
          {written.ask}
        </p>
      )}
      <div class={css["made"]}>{children}</div>
      <p class={css["status"]} data-solved={solved ? "" : undefined} aria-live="polite">
        {solved && (
          <strong>
            <Icon name="check" size={16} /> Solved.{" "}
          </strong>
        )}
        {status}
      </p>
      {drawn && <Squares />}
      <Room lines={drawn ? 2 : 3} />
      <div class={css["hints"]} aria-live="polite">
        {hints.slice(0, told).map((hint, i) => (
          <p key={hint}>
            <span class={css["hint-name"]}>Hint {i + 1}:</span> {hint}
          </p>
        ))}
      </div>
      {told < hints.length && (
        <div class={`${layout["buttons"]} ${solved ? css["needless"] : ""}`}>
          <Button onClick={() => setTold(told + 1)}>{told === 0 ? "A hint" : "Another hint"}</Button>
        </div>
      )}
    </section>
  );
}
