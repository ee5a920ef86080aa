import { Icon } from "#ui/controls/Icon";
import marksCss from "../../marks.module.css";
import { type Answer, type Answers, askedOf } from "../answers";
import css from "../class.module.css";
import { nameOf } from "../names";

interface TableProps {
  all: readonly Answers[];
  /** Whether what is right is not told: whoever reads it may be a pupil. */
  untold?: boolean;
}

/** Who did what: a row a pupil. */
export function Table({ all, untold = false }: TableProps) {
  const asked = askedOf(all);
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls is reached by keys
    <section class={css["table"]} tabIndex={0} aria-label="Who did what">
      <table>
        <thead>
          <tr>
            <th scope="col">Name</th>
            {asked.map((item) => (
              <th key={item} scope="col">
                {calledOn(all, item)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {all.map(({ name, items }) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              {asked.map((item) => (
                <td key={item}>
                  <Cell answer={items.find((one) => one.item === item)} untold={untold} />
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

/** What pupils see it called; a later sheet may say it otherwise. */
export const calledOn = (all: readonly Answers[], item: string): string =>
  all.flatMap(({ items }) => items.find((one) => one.item === item)?.name ?? [])[0] ?? nameOf(item);

function Cell({ answer, untold }: { answer: Answer | undefined; untold: boolean }) {
  if (!answer) return <span class={css["open"]}>not asked</span>;
  const { exercises, answer: words } = answer;
  return (
    <>
      <State answer={answer} untold={untold} />
      {exercises.length > 0 && <p class={css["open"]}>solved: {exercises.join(", ")}</p>}
      {words !== "" && <p>{words}</p>}
    </>
  );
}

/** Right or wrong, where that is known; else only whether it was done. */
function State({
  answer: { item, done, guess, right, truth, answer },
  untold,
}: {
  answer: Answer;
  untold: boolean;
}) {
  const open = item.includes(":") ? "" : "question still open";
  if (!done) return <span class={css["open"]}>{answer === "" ? "not yet" : open}</span>;
  if (item.includes(":")) return <span class={marksCss["done"]}>done</span>;
  if (right === undefined || untold) {
    return <span class={css["open"]}>{guess === "" ? "question answered" : `guessed: ${guess}`}</span>;
  }
  return (
    <>
      <span class={marksCss[right ? "done" : "wrong"]}>
        <Icon name={right ? "check" : "close"} size={16} />
        {right ? "right" : "wrong"}
      </span>
      <p class={css["open"]}>
        guessed: {guess}
        {truth !== undefined && truth !== guess && (
          <>
            <br />
            it is: {truth}
          </>
        )}
      </p>
    </>
  );
}
