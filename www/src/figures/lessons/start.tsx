import { Icon } from "#ui/controls/Icon";
import { Thumbnail } from "../cards";
import { hrefOf } from "../list";
import { LESSONS, type Lesson, UNITS } from "./course";
import marksCss from "./marks.module.css";
import css from "./start.module.css";

/** A first way into the course, by who comes. */
interface Way {
  who: string;
  words: string;
  lessons: readonly string[];
  /** The lesson whose small picture stands above it. */
  shown: string;
  /** Whether its lessons are offered as a sheet for a class. */
  sheet?: boolean;
}

export const WAYS: readonly Way[] = [
  {
    who: "All of this is new to me",
    words: "In a quarter of an hour you know how three small copies make a shape, and why.",
    lessons: ["e12", "e2", "e1"],
    shown: "e12",
  },
  {
    who: "I teach, and have forty minutes",
    words:
      "Three lessons with an exercise each. Show them as slides, print the handouts, or send one link to your class.",
    lessons: ["e12", "e2", "e17"],
    shown: "e2",
    sheet: true,
  },
  {
    who: "I know iterated function systems",
    words: "When is a shape in one piece, what is proved about it, and how is a map of shapes read?",
    lessons: ["e3", "e20", "e21"],
    shown: "e20",
  },
];

const lessonsOf = (ids: readonly string[]) => ids.flatMap((id) => LESSONS.find((one) => one.id === id) ?? []);

/** Where to start, in a few words. */
export function Ways() {
  return (
    <section aria-labelledby="start">
      <h2 id="start">Where to start</h2>
      <ul class={css["ways"]}>
        {WAYS.map(({ who, words, lessons, shown, sheet }) => (
          <li key={who}>
            {lessonsOf([shown]).map((lesson) => (
              <Thumbnail key={lesson.id} of={lesson} />
            ))}
            <h3>{who}</h3>
            <p>{words}</p>
            <ol>
              {lessonsOf(lessons).map((lesson) => (
                <li key={lesson.id}>
                  <a href={hrefOf(lesson)}>{lesson.title}</a>
                </li>
              ))}
            </ol>
            {sheet && (
              <p>
                <a href={`#learn/class/lessons=${lessons.join(",")}`}>These as a class sheet</a>, or{" "}
                <a href="#learn/class">one of your own</a>.
              </p>
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}

const minutesOf = (lessons: readonly Lesson[]) => lessons.reduce((sum, { minutes }) => sum + minutes, 0);

/** Goes to a unit further down. Its heading has the focus then, so that one reads on from there. */
function goTo(id: string): void {
  const heading = document.getElementById(id);
  heading?.scrollIntoView({ block: "start" });
  heading?.focus({ preventScroll: true });
}

/** All units in a few lines, with how far one is. */
export function Glance({ marks }: { marks: ReadonlySet<string> }) {
  return (
    <nav aria-labelledby="glance">
      <h2 id="glance">The units at a glance</h2>
      <ol class={css["glance"]}>
        {UNITS.map(({ id, title, figures }, i) => {
          const count = figures.filter((lesson) => marks.has(lesson.id)).length;
          return (
            <li key={id}>
              <button type="button" onClick={() => goTo(id)}>
                <span class={css["number"]}>{i + 1}</span>
                <span class={css["title"]}>{title}</span>
                <span class={css["overview"]}>
                  {count === 0 ? (
                    `${figures.length} lessons, ${minutesOf(figures)} minutes`
                  ) : (
                    <span class={marksCss["done"]}>
                      <Icon name="check" size={16} /> {count} of {figures.length}
                    </span>
                  )}
                </span>
              </button>
            </li>
          );
        })}
      </ol>
    </nav>
  );
}
