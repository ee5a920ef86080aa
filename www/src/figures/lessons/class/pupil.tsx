import { useContext, useEffect, useState } from "preact/hooks";
import { cameFrom } from "#document/kept/sheet";
import { Icon } from "#ui/controls/Icon";
import { QrCode } from "#ui/overlay/QrCode";
import fieldCss from "../../kit/frame/field.module.css";
import frameCss from "../../kit/frame/frame.module.css";
import layout from "../../kit/frame/layout.module.css";
import { preset } from "../../kit/frame/studio-link";
import { Fitted } from "../../kit/picture/fitted";
import { Page } from "../../kit/state/kept";
import { useValue } from "../../kit/workers";
import { done } from "../frame/done";
import { guessOf, rightOf, truthOf } from "../frame/guesses";
import { printHandouts } from "../frame/handout/paper";
import marksCss from "../marks.module.css";
import { type Answer, type Answers, MOST_WORDS } from "./answers";
import css from "./class.module.css";
import { HandIn } from "./handing/hand-in";
import { timeOf } from "./handing/pack";
import { keep, keptOf } from "./kept";
import { itemsWithNames } from "./names";
import { sheetIn } from "./sheet";

/** The sheet of a class, as those see it who work on it. */
export function Pupil() {
  const { state } = useContext(Page);
  const found = sheetIn(state);
  useEffect(printHandouts, []);
  const isSheet = found !== null;
  useEffect(() => {
    if (isSheet) cameFrom(state);
  }, [state, isSheet]);
  return (
    <div class={`${css["page"]} ${css["sheet"]}`}>
      <p class={css["screen"]}>
        <a href="#learn">All lessons</a>
      </p>
      {found ? (
        <Filled state={state} {...found} />
      ) : (
        <>
          <h1 tabIndex={-1}>Class sheet</h1>
          <p role="alert" class={layout["missing"]}>
            There is nothing on this sheet: the link may have been cut. Ask for it once more, or{" "}
            <a href="#learn">look at all lessons</a>.
          </p>
        </>
      )}
    </div>
  );
}

type FilledProps = NonNullable<ReturnType<typeof sheetIn>> & { state: string };

function Filled({ sheet, whole, state }: FilledProps) {
  const marks = useValue(done);
  const [mine, setMine] = useState(() => keptOf(state));
  const [isKept, setIsKept] = useState(true);
  const items = itemsWithNames(sheet);
  const change = (part: Partial<typeof mine>) => {
    const next = { ...mine, ...part };
    setMine(next);
    setIsKept(keep(next));
  };
  const isDone = (key: string) => (key.includes(":") ? mine.seen.includes(key) : marks.has(key));
  const solved = (key: string) =>
    [...marks].filter((mark) => mark.startsWith(`${key}.`)).map((mark) => Number(mark.split(".")[1]));
  const collect = (): Answers => ({
    name: mine.name.trim(),
    title: sheet.title,
    saved: timeOf(Date.now()),
    items: items.map(
      ({ key, name }): Answer => ({
        item: key,
        done: isDone(key),
        exercises: solved(key).sort((p, q) => p - q),
        guess: key.includes(":") ? "" : guessOf(key),
        ...(rightOf(key) === null ? {} : { right: rightOf(key) === true }),
        ...(truthOf(key) === "" ? {} : { truth: truthOf(key) }),
        name,
        answer: mine.answers[key] ?? "",
      }),
    ),
  });
  return (
    <>
      <div class={css["paper-code"]}>
        <QrCode address={location.href} />
      </div>
      <h1 tabIndex={-1}>{sheet.title || "Class sheet"}</h1>
      <p class={`${frameCss["figure-lead"]} ${css["screen"]}`}>
        Work through these in any order. What you do, guess and write stays in this browser; nobody sees it
        until you hand it in.
        {sheet.hide && " Lessons keep your guess and say later what is right: when your teacher says so."}
      </p>
      {!whole && (
        <p role="status" class={layout["missing"]}>
          Part of this sheet could not be read. Ask whether the link was whole.
        </p>
      )}
      {!isKept && (
        <p role="status" class={layout["missing"]}>
          This browser keeps nothing: hand in your answers before you leave this page.
        </p>
      )}
      <label class={fieldCss["field"]}>
        Your name
        <input
          type="text"
          maxLength={80}
          value={mine.name}
          onInput={({ currentTarget }) => change({ name: currentTarget.value })}
        />
      </label>
      {/* A list without marks of its own is told as one where it says so. */}
      {/* biome-ignore lint/a11y/noRedundantRoles: Safari */}
      <ol role="list" class={css["items"]}>
        {items.map(({ key, name, href, task, shape }, i) => {
          const count = solved(key).length;
          return (
            <li key={key}>
              <div class={css["item-head"]}>
                <span aria-hidden="true">{i + 1}.</span>
                {shape !== undefined && (
                  <div class={`${css["small"]} ${css["screen"]}`} aria-hidden="true">
                    <Fitted of={preset(shape).maps} />
                  </div>
                )}
                {href === null ? <span>{name}</span> : <a href={href}>{name}</a>}
                {key.includes(":") ? (
                  <label class={css["tick"]}>
                    <input
                      type="checkbox"
                      checked={isDone(key)}
                      onChange={({ currentTarget }) =>
                        change({
                          seen: currentTarget.checked
                            ? [...mine.seen, key]
                            : mine.seen.filter((one) => one !== key),
                        })
                      }
                    />
                    done
                  </label>
                ) : (
                  // A tick beside a guess would say that it is right.
                  <span class={isDone(key) && !sheet.hide ? marksCss["done"] : css["open"]}>
                    {isDone(key) && !sheet.hide && <Icon name="check" size={16} />}
                    {!isDone(key)
                      ? "the lesson’s question is still open"
                      : sheet.hide
                        ? "your guess is kept"
                        : "the lesson’s question is answered"}
                    {count > 0 && `, ${count} exercise${count === 1 ? "" : "s"} solved`}
                  </span>
                )}
              </div>
              {task !== "" && <p class={css["task"]}>{task}</p>}
              <label class={fieldCss["field"]}>
                What did you find?
                <textarea
                  rows={2}
                  maxLength={MOST_WORDS}
                  value={mine.answers[key] ?? ""}
                  aria-label={`What did you find? ${name}`}
                  onInput={({ currentTarget }) =>
                    change({ answers: { ...mine.answers, [key]: currentTarget.value } })
                  }
                />
              </label>
            </li>
          );
        })}
      </ol>
      <HandIn named={mine.name.trim() !== ""} collect={collect} />
      <p class={`${css["open"]} ${css["screen"]}`}>
        For teachers: <a href={`#learn/class/${state}`}>change this sheet</a>
      </p>
    </>
  );
}
