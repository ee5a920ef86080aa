import marksCss from "../../marks.module.css";
import { type Answer, type Answers, askedOf } from "../answers";
import css from "../class.module.css";
import { nameOf } from "../names";

/** Who did what: a row a pupil. */
export function Table({ all }: { all: readonly Answers[] }) {
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
                  <Cell answer={items.find((one) => one.item === item)} />
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

function Cell({ answer }: { answer: Answer | undefined }) {
  if (!answer) return <span class={css["open"]}>not asked</span>;
  const { item, done, exercises, guess, right, answer: words } = answer;
  // Of a lesson it is said what was looked at; whether it was guessed right stands below.
  const [isDone, isOpen] = item.includes(":") ? ["done", "not yet"] : ["question answered", "question open"];
  const good = done && right !== false && (item.includes(":") || right === true);
  return (
    <>
      <span class={good ? marksCss["done"] : css["open"]}>{done ? isDone : isOpen}</span>
      {exercises.length > 0 && <span class={css["open"]}>, solved: {exercises.join(", ")}</span>}
      {guess !== "" && (
        <p class={css["open"]}>
          guessed{right !== undefined && (right ? " right" : " wrong")}: {guess}
        </p>
      )}
      {words !== "" && <p>{words}</p>}
    </>
  );
}
