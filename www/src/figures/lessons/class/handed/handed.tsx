import { useEffect, useRef, useState } from "preact/hooks";
import { reasonOf } from "#document/kept/database";
import { notify } from "#document/notice";
import { Button } from "#ui/controls/Button";
import { Select } from "#ui/controls/Select";
import { download, plainName } from "#ui/files/download";
import fieldCss from "../../../kit/frame/field.module.css";
import layout from "../../../kit/frame/layout.module.css";
import { type Answers, keyOf, latest, MOST_BYTES, read, titlesOf } from "../answers";
import css from "../class.module.css";
import { HandedIn } from "./handed-in";
import { spreadsheet } from "./spreadsheet";
import { calledOn, Table } from "./table";

/** So many files are read at once; a class is smaller. */
const MOST_FILES = 200;

const kept = new HandedIn();

interface Unread {
  file: string;
  why: string;
}

/** What was handed in: who did what. It is kept in this browser, a table for each sheet. */
export function Handed() {
  const [all, setAll] = useState<readonly Answers[]>([]);
  const [unread, setUnread] = useState<readonly Unread[]>([]);
  const [problem, setProblem] = useState<string | null>(null);
  const [wanted, setWanted] = useState<string | null>(null);
  const input = useRef<HTMLInputElement>(null);
  const add = (more: readonly Answers[]) => setAll((before) => latest([...before, ...more]));
  const after = (work: Promise<void>) =>
    work.then(
      () => setProblem(null),
      (reason) => setProblem(reasonOf(reason)),
    );
  useEffect(() => {
    let here = true;
    kept.list().then(
      (found) => here && setAll((before) => latest([...before, ...found])),
      // It is told when there is something to keep.
      () => undefined,
    );
    return () => {
      here = false;
    };
  }, []);
  const titles = titlesOf(all);
  const title = titles.find((one) => one === wanted) ?? titles[0] ?? "";
  const shown = all.filter((one) => one.title === title);
  const open = async (files: readonly File[]) => {
    const found: Answers[] = [];
    const problems: Unread[] = [];
    for (const file of files.slice(0, MOST_FILES)) {
      const answers = await readFile(file);
      if (typeof answers === "string") problems.push({ file: file.name, why: answers });
      else found.push(answers);
    }
    add(found);
    if (found[0]) {
      setWanted(found[0].title);
      await after(kept.keep(found));
    }
    setUnread(problems);
  };
  const clear = () => {
    const gone = new Set(shown.map(keyOf));
    setAll((before) => before.filter((one) => !gone.has(keyOf(one))));
    setUnread([]);
    void after(kept.remove(shown));
    notify({
      kind: "info",
      text: `The answers to ${called(title)} were removed from this browser.`,
      action: {
        label: "Undo",
        run() {
          add(shown);
          void after(kept.keep(shown));
        },
      },
    });
  };
  const save = () => {
    const text = spreadsheet(shown, (item) => calledOn(shown, item));
    download(new Blob([text], { type: "text/csv" }), `answers-${plainName(title, "class")}.csv`);
  };
  return (
    <section class={css["part"]} aria-labelledby="handed">
      <h2 id="handed" class={css["screen"]}>
        Answers of your class
      </h2>
      <div class={`${layout["buttons"]} ${css["screen"]}`}>
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
        {shown.length > 0 && (
          <>
            <Button icon="save" description="to be opened by a spreadsheet" onClick={save}>
              Save as CSV
            </Button>
            <Button icon="print" onClick={() => print()}>
              Print the table
            </Button>
            <Button kind="quiet" icon="bin" onClick={clear}>
              Clear the table
            </Button>
          </>
        )}
      </div>
      <div role="status" class={css["screen"]}>
        {unread.map(({ file, why }) => (
          <p key={file} class={layout["missing"]}>
            {file}: {why}
          </p>
        ))}
        {problem !== null && (
          <p class={layout["missing"]}>{problem} Save the table before you leave this page.</p>
        )}
      </div>
      {titles.length > 1 && (
        <label class={`${fieldCss["field"]} ${css["screen"]}`}>
          Answers to
          <Select value={title} onChange={({ currentTarget }) => setWanted(currentTarget.value)}>
            {titles.map((one) => (
              <option key={one} value={one}>
                {one || "a sheet without a title"}
              </option>
            ))}
          </Select>
        </label>
      )}
      {shown.length === 0 ? (
        <p class={`${layout["hint"]} ${css["screen"]}`}>
          Several may be opened at once. They are read and kept in this browser, and go nowhere.
        </p>
      ) : (
        <>
          <p class={css["table-title"]} aria-hidden="true">
            {title || "Class sheet"}
          </p>
          <p class={css["handed-in"]}>
            <span class={css["screen"]}>{called(title)}: </span>
            {shown.length} handed in, the last on {dayOf(shown)}
          </p>
          <Table all={shown} />
          <p class={`${layout["hint"]} ${css["screen"]}`}>
            This browser keeps the table until you clear it. Nobody else sees it, and it goes nowhere.
          </p>
        </>
      )}
    </section>
  );
}

const called = (title: string) => (title === "" ? "a sheet without a title" : `“${title}”`);

/** The day of the latest, as the browser's language has it. */
function dayOf(all: readonly Answers[]): string {
  const last = new Date(
    all
      .map(({ saved }) => saved)
      .sort()
      .at(-1) ?? "",
  );
  return Number.isNaN(last.getTime())
    ? "an unknown day"
    : last.toLocaleDateString("en-GB", { dateStyle: "long" });
}

async function readFile(file: File): Promise<Answers | string> {
  if (file.size > MOST_BYTES) return "This file is too large to be one of answers.";
  try {
    return read(await file.text());
  } catch {
    return "This file could not be read. Try it once more.";
  }
}
