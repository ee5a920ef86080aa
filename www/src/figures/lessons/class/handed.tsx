import { useRef, useState } from "preact/hooks";
import { Button } from "#ui/controls/Button";
import layout from "../../kit/frame/layout.module.css";
import { type Answer, type Answers, askedOf, latest, MOST_BYTES, read } from "./answers";
import css from "./class.module.css";
import { nameOf } from "./names";

/** So many files are read at once; a class is smaller. */
const MOST_FILES = 200;

interface Unread {
  file: string;
  why: string;
}

/** What was handed in: who did what. */
export function Handed() {
  const [all, setAll] = useState<readonly Answers[]>([]);
  const [unread, setUnread] = useState<readonly Unread[]>([]);
  const input = useRef<HTMLInputElement>(null);
  const open = async (files: readonly File[]) => {
    const found: Answers[] = [];
    const problems: Unread[] = [];
    for (const file of files.slice(0, MOST_FILES)) {
      const answers = await readFile(file);
      if (typeof answers === "string") problems.push({ file: file.name, why: answers });
      else found.push(answers);
    }
    setAll((before) => latest([...before, ...found]));
    setUnread(problems);
  };
  return (
    <section class={css["part"]} aria-labelledby="handed">
      <h2 id="handed">Answers of your class</h2>
      <div class={layout["buttons"]}>
        <Button icon="open" onClick={() => input.current?.click()}>
          Open files of answers
        </Button>
        <input
          ref={input}
          class="unseen"
          type="file"
          multiple
          accept="application/json,.json"
          aria-label="Files of answers"
          tabIndex={-1}
          onChange={({ currentTarget }) => {
            void open([...(currentTarget.files ?? [])]);
            // The same files once more are a choice, too.
            currentTarget.value = "";
          }}
        />
        {all.length > 0 && (
          <Button
            kind="quiet"
            onClick={() => {
              setAll([]);
              setUnread([]);
            }}
          >
            Clear the table
          </Button>
        )}
      </div>
      <div role="status">
        {unread.map(({ file, why }) => (
          <p key={file} class={layout["missing"]}>
            {file}: {why}
          </p>
        ))}
      </div>
      {all.length === 0 ? (
        <p class={layout["hint"]}>Several may be opened at once. They are read here, and go nowhere.</p>
      ) : (
        <Table all={all} />
      )}
    </section>
  );
}

async function readFile(file: File): Promise<Answers | string> {
  if (file.size > MOST_BYTES) return "This file is too large to be one of answers.";
  try {
    return read(await file.text());
  } catch {
    return "This file could not be read. Try it once more.";
  }
}

function Table({ all }: { all: readonly Answers[] }) {
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
                {calledOn(all, item) ?? nameOf(item)}
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
const calledOn = (all: readonly Answers[], item: string) =>
  all.flatMap(({ items }) => items.find((one) => one.item === item)?.name ?? [])[0];

function Cell({ answer }: { answer: Answer | undefined }) {
  if (!answer) return <span class={css["open"]}>not asked</span>;
  const { item, done, exercises, guess, right, answer: words } = answer;
  const isDone = item.includes(":") ? "done" : "question answered";
  return (
    <>
      <span class={done ? css["done"] : css["open"]}>{done ? isDone : "not yet"}</span>
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
