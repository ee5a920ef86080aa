import { useContext, useLayoutEffect, useRef, useState } from "preact/hooks";
import { Button } from "#ui/controls/Button";
import { useValue } from "../../kit/workers";
import { paper } from "./handout/paper";
import { Hidden } from "./hidden";
import css from "./teaching.module.css";

/** An exercise as a handout has it, where nothing can be pressed or dragged. */
export interface PaperExercise {
  ask: string;
  /** What is there besides lines to write on: the picture of the exercise as it begins, or squares to draw on. */
  space?: "picture" | "squares";
  answer: string;
}

/** What a teacher wants to know of a lesson. */
export interface Teaching {
  /** What one can do after it that one could not before. */
  aim: string;
  /** What is often thought at first, and is not so. */
  mistakes: readonly string[];
  /** To ask a class, each with an answer. */
  questions: readonly { ask: string; answer: string }[];
  /** The answer to the lesson's own question. */
  answer: string;
  /** A solution of each exercise, in their order. */
  solutions: readonly string[];
  /** The exercises of the handout, in the same order; `same` is one that needs paper only. */
  onPaper: readonly (PaperExercise | "same")[];
}

interface ForTeachersProps {
  /** The lesson, as paper names it. */
  lesson: string;
  teaching: Teaching;
}

/** For whoever teaches with it; folded away for those who learn. On paper it is a page of its own. */
export function ForTeachers({ lesson, teaching }: ForTeachersProps) {
  const { aim, mistakes, questions, answer, solutions, onPaper } = teaching;
  const fold = useRef<HTMLDetailsElement>(null);
  const covered = useValue(paper);
  const [told, setTold] = useState(false);
  const hidden = useContext(Hidden);
  const answers = told || covered;
  useLayoutEffect(() => {
    if (!covered || !fold.current || fold.current.open) return;
    const opened = fold.current;
    opened.open = true;
    return () => {
      opened.open = false;
    };
  }, [covered]);
  return (
    <details class={css["teaching"]} ref={fold} data-part="answers">
      <summary>For teachers</summary>
      <div>
        <p class={css["paper-name"]}>Answers, and words for teachers: {lesson}</p>
        <h3>Aim</h3>
        <p>{aim}</p>
        {!answers && hidden && (
          <p>The class sheet that led here hides the answers for now. The teacher’s own link shows them.</p>
        )}
        {!answers && !hidden && (
          <>
            <p>The answers are not shown yet: whoever learns here may want to try first.</p>
            <div>
              <Button onClick={() => setTold(true)}>Show the answers</Button>
            </div>
          </>
        )}
        {answers && (
          <>
            <h3>The question</h3>
            <p>{answer}</p>
          </>
        )}
        {answers && solutions.length > 0 && (
          <>
            <h3>Solutions of the exercises</h3>
            <ol>
              {solutions.map((solution, i) => (
                <li key={solution}>{covered ? answerOf(onPaper[i], solution) : solution}</li>
              ))}
            </ol>
          </>
        )}
        {!covered && onPaper.some((one) => one !== "same") && (
          <>
            <h3>On the handout</h3>
            <p>Nothing can be dragged there, so these take the place of exercises of the page:</p>
            <ul>
              {onPaper.map(
                (one, i) =>
                  one !== "same" && (
                    <li key={one.ask}>
                      {`Exercise ${i + 1}: ${one.ask} `}
                      {answers && <em>{one.answer}</em>}
                    </li>
                  ),
              )}
            </ul>
          </>
        )}
        {/* They say of an option why it is wrong. */}
        {(answers || !hidden) && (
          <>
            <h3>Common mistakes</h3>
            <ul>
              {mistakes.map((mistake) => (
                <li key={mistake}>{mistake}</li>
              ))}
            </ul>
          </>
        )}
        <h3>Questions for the class</h3>
        <ol>
          {questions.map(({ ask, answer }) => (
            <li key={ask}>
              {ask} {answers && <em>{answer}</em>}
            </li>
          ))}
        </ol>
      </div>
    </details>
  );
}

const answerOf = (onPaper: PaperExercise | "same" | undefined, solution: string) =>
  onPaper === undefined || onPaper === "same" ? solution : onPaper.answer;
