import type { ComponentChildren } from "preact";
import { useContext, useEffect, useRef, useState } from "preact/hooks";
import { sheetHides } from "#document/kept/sheet";
import { Button } from "#ui/controls/Button";
import { Menu } from "#ui/overlay/Menu";
import { Head, type Heading, type Parameter, Parameters } from "../../kit/frame/frame";
import frameCss from "../../kit/frame/frame.module.css";
import layout from "../../kit/frame/layout.module.css";
import { CopyLink } from "../../kit/state/copy-link";
import { flag } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { useValue } from "../../kit/workers";
import { markDone } from "./done";
import { guessOf, guessWords, keepGuess, keepTruth, truthWords } from "./guesses";
import { printHandout, printHandouts } from "./handout/paper";
import { Room, Whose } from "./handout/room";
import { Hidden } from "./hidden";
import css from "./lesson.module.css";
import { LessonId, OnPaper } from "./lesson-id";
import type { Prediction } from "./prediction";
import { slide } from "./slides/on-slides";
import { Slides, SlidesButton } from "./slides/slides";
import { ForTeachers, type Teaching } from "./teaching";

interface LessonProps extends Heading {
  /** Two or three plain paragraphs. */
  text: ComponentChildren;
  /** The finished picture: it is read without touching it. */
  children: ComponentChildren;
  /** What is asked, and what is seen after. */
  question: ComponentChildren;
  /** What is to be made at the end, which the program checks. */
  exercises?: ComponentChildren;
  teaching: Teaching;
  parameters: readonly Parameter[];
  /** Who found what is told here. */
  sources: ComponentChildren;
  studio: { href: string; label?: string };
}

/** What every lesson has around its pictures. Nothing of it was printed in a paper. */
export function Lesson(props: LessonProps) {
  useEffect(printHandouts, []);
  const [asked] = useKept("hide", false, flag);
  const hidden = asked || sheetHides();
  return (
    <LessonId.Provider value={props.id}>
      <Hidden.Provider value={hidden}>
        <div class={css["first"]} data-part="copies">
          <Whose lesson={props.id} />
          <Head
            number={props.number}
            title={props.title}
            badge="by Frond"
            studio={props.studio}
            more={
              <>
                <SlidesButton />
                <PrintMenu />
              </>
            }
          >
            {props.text}
          </Head>
          <section
            class={frameCss["figure-live"]}
            data-testid="live"
            data-step="picture"
            aria-label="The picture"
          >
            {props.children}
          </section>
          {props.question}
        </div>
        {props.exercises !== undefined && (
          <div class={css["exercises"]} data-part="copies">
            <h2 class={css["make"]}>Now make one yourself</h2>
            <p class={css["paper-name"]} aria-hidden="true">
              {props.number}, {props.title}
            </p>
            <OnPaper.Provider value={props.teaching.onPaper}>{props.exercises}</OnPaper.Provider>
          </div>
        )}
        <div class={`${frameCss["figure-foot"]} ${css["foot"]}`} data-part="answers">
          <section aria-labelledby="figure-parameters">
            <h2 id="figure-parameters">Parameters</h2>
            <Parameters of={props.parameters} />
          </section>
          <section aria-labelledby="figure-sources">
            <h2 id="figure-sources">Where this comes from</h2>
            {props.sources}
          </section>
        </div>
        <ForTeachers lesson={`${props.number}, ${props.title}`} teaching={props.teaching} />
        <Slides />
      </Hidden.Provider>
    </LessonId.Provider>
  );
}

/** A handout, with room to write: what pupils get, and the answers apart from it. */
function PrintMenu() {
  return (
    <Menu
      label="Print a handout"
      icon="print"
      items={[
        { label: "Copies for pupils, without answers", onSelect: () => void printHandout("copies") },
        { label: "The answers alone", onSelect: () => void printHandout("answers") },
        { label: "Both", onSelect: () => void printHandout("all") },
      ]}
    />
  );
}

export interface QuestionProps {
  prediction: Prediction<unknown>;
  /**
   * What is so: an answer of those to choose from, what all those that are to be ticked are called, or a number. Null
   * while it is being found out.
   */
  truth?: string | readonly string[] | number | null;
  /** How far a number may be from it and still be right. */
  within?: number;
  /** Whether there is something to look at beside the question; it stays in its place when the truth comes. */
  beside?: ComponentChildren;
  /** What is asked: choices or a slider, with the question as their name. */
  children: ComponentChildren;
  /** The truth beside the prediction, and why. */
  answer: ComponentChildren;
  /** What can be tried once it is known, below both. */
  after?: ComponentChildren;
}

/** Asks for a prediction and then shows what is so. The one button keeps its place, and with it the focus. */
export function Question(props: QuestionProps) {
  const { prediction, truth = null, within = 0, beside, children, answer, after } = props;
  const { guess, said, shown, show, again } = prediction;
  const lesson = useContext(LessonId);
  const question = useRef<HTMLElement>(null);
  // On slides it is a class that guesses, and not who has done lessons in this browser.
  const own = useValue(slide) === null;
  const hidden = useContext(Hidden);
  const [kept, setKept] = useState(() => (hidden ? guessOf(lesson) : ""));
  const keep = () => {
    keepGuess(lesson, guessWords(question.current, guess));
    markDone(lesson);
  };
  const look = () => {
    if (own) keep();
    show();
  };
  const keepOnly = () => {
    keep();
    setKept(guessOf(lesson));
  };
  const looked = hidden ? kept !== "" : shown;
  useEffect(() => {
    if (!own || !looked || truth === null) return;
    const words = guessWords(question.current, guess);
    const so = truthWords(question.current, truth);
    const right =
      typeof truth === "number" && typeof guess === "number"
        ? Math.abs(guess - truth) <= within + 1e-9
        : words === so;
    keepTruth(lesson, words, right, so);
  }, [own, lesson, looked, guess, truth, within]);
  return (
    <section
      ref={question}
      class={`${frameCss["figure-live"]} ${css["question"]}`}
      data-testid="live"
      data-step="question"
      aria-labelledby="question"
    >
      <div class={frameCss["step-head"]}>
        <h2 id="question">What do you think?</h2>
        <CopyLink step="question" />
      </div>
      <div
        class={
          beside === undefined
            ? css["question-alone"]
            : `${layout["two-columns"]} ${layout["even"]} ${css["beside"]}`
        }
      >
        {beside !== undefined && <div class={layout["panel"]}>{beside}</div>}
        <div class={css["ask"]}>
          {/* What was kept is what is handed in. */}
          <fieldset class={css["asked"]} disabled={hidden && !shown && kept !== ""}>
            {children}
          </fieldset>
          <Room lines={beside === undefined ? 4 : 2} most={7} />
          <div class={`${layout["buttons"]} ${css["look"]}`}>
            {hidden && !shown ? (
              <>
                <Button kind="primary" disabled={!said || kept !== ""} onClick={keepOnly}>
                  Keep my guess
                </Button>
                <p class={layout["hint"]} role="status">
                  {kept !== ""
                    ? `Your guess is kept: ${kept}. Your teacher shows later what is right.`
                    : said
                      ? ""
                      : "Make a guess, then keep it. It cannot be changed later."}
                </p>
              </>
            ) : (
              <>
                <Button kind={shown ? "plain" : "primary"} disabled={!said} onClick={shown ? again : look}>
                  {shown ? "Think again" : "Show me"}
                </Button>
                {!said && <p class={layout["hint"]}>Make a guess, then look.</p>}
              </>
            )}
          </div>
          <div class={css["answer"]} aria-live="polite">
            {shown && answer}
          </div>
        </div>
      </div>
      {shown && after}
    </section>
  );
}

/** The truth in a line, and the reason below it. */
export function Truth({ line, children }: { line: ComponentChildren; children: ComponentChildren }) {
  return (
    <>
      <p class={css["truth"]} data-testid="truth">
        {line}
      </p>
      {children}
    </>
  );
}
