import { signal } from "@preact/signals";
import { Button } from "#ui/controls/Button";
import { Icon } from "#ui/controls/Icon";
import { Cards } from "../cards";
import type { Figure } from "../figure";
import { Find } from "../find/Find";
import frameCss from "../kit/frame/frame.module.css";
import layout from "../kit/frame/layout.module.css";
import { useValue } from "../kit/workers";
import { hrefOf } from "../list";
import overviewCss from "../overview.module.css";
import css from "./contents.module.css";
import { LESSONS, type Lesson, UNITS } from "./course";
import { lessonsWith } from "./find";
import { clearDone, done } from "./frame/done";
import { clearGuesses } from "./frame/guesses";
import marksCss from "./marks.module.css";
import { Glance, Ways } from "./start";

/** What is looked for; it is there again on the way back from a lesson. */
const asked = signal("");

/** The course: its units, the lessons of each, and how far one is. */
export function Contents({ missing }: { missing: string | null }) {
  const marks = useValue(done);
  const words = useValue(asked);
  const count = LESSONS.filter(({ id }) => marks.has(id)).length;
  const next = LESSONS.find(({ id }) => !marks.has(id));
  return (
    <div class={overviewCss["overview"]}>
      <header>
        <h1 tabIndex={-1}>Learn</h1>
        {missing !== null && (
          <p role="status" class={layout["missing"]}>
            There is no lesson “{missing}”. Here are those there are.
          </p>
        )}
        <p class={frameCss["figure-lead"]}>
          Shapes made of smaller copies of themselves, from the beginning: one idea a lesson. Play first, then
          guess, then see what is so. Nothing is asked of you but curiosity.
        </p>
        <p class={css["progress"]}>
          {next && (
            <a class={`button primary ${css["go"]}`} href={hrefOf(next)}>
              {count === 0 ? "Begin" : "Go on"}: {next.title}
              <Icon name="arrow" />
            </a>
          )}
          {count > 0 && (
            <>
              <span>
                Question answered in {count} of {LESSONS.length} lessons. This browser keeps the marks, nobody
                else sees them.
              </span>
              <Button kind="quiet" onClick={clear}>
                Clear the marks
              </Button>
            </>
          )}
        </p>
        <Find
          label="Find a lesson by a word"
          example="fern, dimension, proof …"
          value={words}
          onChange={(next) => {
            asked.value = next;
          }}
        />
      </header>
      {words.trim() === "" ? <Units marks={marks} /> : <Found words={words} marks={marks} />}
      <p class={css["papers"]}>
        All of it comes from somewhere: <a href="#figures">the figures of four papers</a>, each as a page that
        moves.
      </p>
    </div>
  );
}

function Units({ marks }: { marks: ReadonlySet<string> }) {
  return (
    <>
      <Ways />
      <Glance marks={marks} />
      <ol class={css["units"]}>
        {UNITS.map(({ id, title, about, figures }) => (
          <li key={id}>
            <section aria-labelledby={id}>
              <h2 id={id} tabIndex={-1}>
                {title}
              </h2>
              <p class={frameCss["figure-lead"]}>{about}</p>
              <Cards figures={figures} also={(lesson) => <Facts lesson={lesson} marks={marks} />} />
            </section>
          </li>
        ))}
      </ol>
    </>
  );
}

/** The lessons in which the words are, as one row. */
function Found({ words, marks }: { words: string; marks: ReadonlySet<string> }) {
  const found = lessonsWith(words);
  return (
    <section aria-label="Lessons found">
      <p role="status">
        {found.length === 0
          ? `No lesson says “${words.trim()}” of itself. Try another word, or the beginning of one.`
          : `${found.length} ${found.length === 1 ? "lesson" : "lessons"} with “${words.trim()}”.`}
      </p>
      <Cards figures={found} also={(lesson) => <Facts lesson={lesson} marks={marks} />} />
      <div>
        <Button
          onClick={() => {
            asked.value = "";
          }}
        >
          Show all lessons
        </Button>
      </div>
    </section>
  );
}

/** As if nobody had been here. */
function clear(): void {
  clearDone();
  clearGuesses();
}

/** How long it takes, what it builds on, and what of it is done: the question is one thing, the exercises another. */
function Facts({ lesson, marks }: { lesson: Lesson; marks: ReadonlySet<string> }) {
  const solved = [...marks].filter((mark) => mark.startsWith(`${lesson.id}.`)).length;
  const facts = [
    ...(marks.has(lesson.id) ? ["question answered"] : []),
    ...(solved > 0 ? [`${solved} exercise${solved === 1 ? "" : "s"} solved`] : []),
  ];
  const after = lesson.after.flatMap((id) => LESSONS.find((other) => other.id === id) ?? []);
  return (
    <span class={css["lesson-facts"]}>
      <span>
        {lesson.minutes} minutes{after.length > 0 && `, after ${lessonsWords(after)}`}
      </span>
      {facts.length > 0 && (
        <span class={marksCss["done"]}>
          <Icon name="check" size={16} /> {facts.join(", ")}
        </span>
      )}
    </span>
  );
}

/** "lesson 3", "lessons 3 and 5" */
function lessonsWords(lessons: readonly Figure[]): string {
  const numbers = lessons.map(({ short }) => short);
  return `${numbers.length === 1 ? "lesson" : "lessons"} ${numbers.join(" and ")}`;
}
