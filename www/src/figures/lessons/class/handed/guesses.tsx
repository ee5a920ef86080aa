import { Icon } from "#ui/controls/Icon";
import marksCss from "../../marks.module.css";
import type { Answers } from "../answers";
import { type Counted, countsOf } from "./counts";
import css from "./guesses.module.css";
import { calledOn } from "./table";

/** How a class guessed, without names: it may be shown to all. */
export function Guesses({ all }: { all: readonly Answers[] }) {
  const counted = countsOf(all);
  if (counted.length === 0) return null;
  return (
    <details class={css["guesses"]}>
      <summary>How the class guessed, without names</summary>
      <div class={css["questions"]}>
        {counted.map((one) => (
          <Question key={one.item} name={calledOn(all, one.item)} of={one} />
        ))}
      </div>
    </details>
  );
}

function Question({ name, of: { guessed, asked, right, counts } }: { name: string; of: Counted }) {
  const most = Math.max(...counts.map(({ count }) => count), 1);
  return (
    <table class={css["counts"]}>
      <caption>
        <strong>{name}</strong>: {guessed} of {asked} guessed
        {right !== null && `, ${right} right`}
      </caption>
      <thead class="unseen">
        <tr>
          <th scope="col">Guess</th>
          <th scope="col">Pupils</th>
        </tr>
      </thead>
      <tbody>
        {counts.map(({ label, count, so }) => (
          <tr key={label}>
            <th scope="row">
              {label}
              {so && (
                <>
                  {" "}
                  <span class={marksCss["done"]}>
                    <Icon name="check" size={16} /> right
                  </span>
                </>
              )}
            </th>
            <td>
              <span
                class={css["count-bar"]}
                data-so={so ? "" : undefined}
                style={{ width: `${(70 * count) / most}%` }}
              />
              <span class="number">{count}</span>
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
