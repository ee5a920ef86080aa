import { useEffect, useRef, useState } from "preact/hooks";
import { notify } from "#document/notice";
import { Button } from "#ui/controls/Button";
import { Select } from "#ui/controls/Select";
import { download, plainName } from "#ui/files/download";
import fieldCss from "../../../kit/frame/field.module.css";
import layout from "../../../kit/frame/layout.module.css";
import type { Answers } from "../answers";
import css from "../class.module.css";
import { codesIn } from "../handing/find";
import { classSize, keepClassSize } from "../kept";
import {
  type Arrival,
  arrivalWords,
  called,
  type Line,
  mostOf,
  type Problems,
  problemLines,
  reportOf,
} from "./arrive";
import { bring, otherCode } from "./bring";
import { Guesses } from "./guesses";
import { type Heard, Scan } from "./scan";
import { spreadsheet } from "./spreadsheet";
import { calledOn, Table } from "./table";
import { type Answered, useTable } from "./use-table";

const NONE_PASTED =
  "There are no answers in what you pasted. Pupils copy theirs on their sheet, by “Copy link” or “Copy word”.";

interface HandedProps {
  /** The address of a link with answers; null where it is none. */
  link: string | null;
  /** The title of the sheet in the making; null where there is none. */
  draft: string | null;
}

/** What was handed in: who did what. It is kept in this browser, a table for each sheet. */
export function Handed({ link, draft }: HandedProps) {
  const table = useTable();
  const { titles, title, shown, problem } = table;
  const [report, setReport] = useState<readonly Line[]>([]);
  const say = (found: readonly Answers[], problems: Problems, others: readonly Line[] = []) => {
    const most = mostOf(found);
    const { arrivals, kept } = table.take(found, most);
    const lines = [...reportOf(arrivals, most ?? ""), ...problemLines(problems), ...others];
    // Who reads it may close the page.
    void kept.then(() => setReport(lines));
  };
  const alone = useLink(link, draft, table, say);
  const clear = async () => {
    setReport([]);
    await table.remove(shown);
    notify({
      kind: "info",
      text: `The answers to ${called(title)} were removed from this browser.`,
      action: { label: "Undo", run: () => table.restore(shown) },
    });
  };
  const save = () => {
    const text = spreadsheet(shown, (item) => calledOn(shown, item));
    download(new Blob([text], { type: "text/csv" }), `answers-${plainName(title, "class")}.csv`);
  };
  return (
    <section class={css["part"]} aria-labelledby="handed">
      <h2 id="handed" class={css["screen"]} tabIndex={-1}>
        Answers of your class
      </h2>
      {alone && (
        <Alone
          answers={alone}
          onAdd={() => say([alone], { damaged: 0, later: 0, more: false })}
          added={shown.some(({ name, title }) => name === alone.name && title === alone.title)}
        />
      )}
      <Ways table={table} say={say} onReport={setReport} />
      <div role="status" class={css["screen"]}>
        {report.map(({ words, problem }) => (
          <p key={words} class={problem ? layout["missing"] : undefined}>
            {words}
          </p>
        ))}
        {problem !== null && (
          <p class={layout["missing"]}>{problem} Save the table before you leave this page.</p>
        )}
      </div>
      {titles.length > 1 && (
        <label class={`${fieldCss["field"]} ${css["screen"]}`}>
          Answers to
          <Select value={title} onChange={({ currentTarget }) => table.show(currentTarget.value)}>
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
          Answers are read and kept in this browser, and go nowhere.
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
          <div class={`${layout["buttons"]} ${css["screen"]}`}>
            <Button icon="save" description="to be opened by a spreadsheet" onClick={save}>
              Save as CSV
            </Button>
            <Button icon="print" onClick={() => print()}>
              Print the table
            </Button>
            <Button kind="quiet" icon="bin" onClick={clear}>
              Clear the table
            </Button>
          </div>
          <Guesses all={shown} />
          <Table all={shown} />
          <p class={`${layout["hint"]} ${css["screen"]}`}>
            This browser keeps the table until you clear it. Nobody else sees it, and it goes nowhere.
          </p>
        </>
      )}
    </section>
  );
}

type Say = (found: readonly Answers[], problems: Problems, others?: readonly Line[]) => void;

/** What a link holds: it goes into the table where its sheet is known here, and is given back where it is not. */
function useLink(link: string | null, draft: string | null, table: Answered, say: Say): Answers | null {
  const [alone, setAlone] = useState<Answers | null>(null);
  const { all, titles } = table;
  const ready = all !== null;
  // biome-ignore lint/correctness/useExhaustiveDependencies: once, when it is known what is kept here
  useEffect(() => {
    if (!ready || link === null) return;
    const { answers, ...problems } = codesIn(link);
    const [one] = answers;
    if (!one) say([], { ...problems, damaged: problems.later > 0 ? 0 : 1 });
    else if (one.title === draft || titles.includes(one.title)) say([one], problems);
    else setAlone(one);
  }, [ready]);
  return alone;
}

/** The answers of one pupil to a sheet that this browser does not know. */
function Alone({ answers, added, onAdd }: { answers: Answers; added: boolean; onAdd: () => void }) {
  const { name, title } = answers;
  if (added) return null;
  return (
    <div class={css["part"]}>
      <p>
        This link holds the answers of {name} to {called(title)}. If they are yours, send the link to your
        teacher. No table of that sheet is in this browser: what is right is shown once there is one.
      </p>
      <Table all={[answers]} untold />
      <div class={layout["buttons"]}>
        <Button onClick={onAdd}>For teachers: begin a table with them</Button>
      </div>
    </div>
  );
}

interface WaysProps {
  table: Answered;
  say: Say;
  onReport: (lines: readonly Line[]) => void;
}

/** The ways by which answers come in. */
function Ways({ table, say, onReport }: WaysProps) {
  const [busy, setBusy] = useState("");
  const [typed, setTyped] = useState("");
  const [scanning, setScanning] = useState(false);
  const [size, setSize] = useState(classSize);
  const input = useRef<HTMLInputElement>(null);
  /** The sheet whose codes are being scanned: that of the first. */
  const target = useRef<string | null>(null);
  const heard = useRef<Arrival[]>([]);
  const open = async (files: readonly File[]) => {
    onReport([]);
    const many = files.length;
    const { found, unread, ...problems } = await bring(files, (done) =>
      setBusy(many > 1 ? `Reading ${done + 1} of ${many} files …` : "Reading the file …"),
    );
    setBusy("");
    const lines = unread.map(({ file, why }) => ({ words: `${file}: ${why}`, problem: true }));
    say(found, problems, lines);
  };
  const openText = (text: string) => {
    const { answers, ...problems } = codesIn(text);
    const none = answers.length === 0 && problems.damaged + problems.later === 0;
    say(answers, problems, none ? [{ words: NONE_PASTED, problem: true }] : []);
    return !none;
  };
  const scanned = (text: string): Heard => {
    const { answers, ...problems } = codesIn(text);
    const [one] = answers;
    if (!one) {
      const [line] = problemLines(problems);
      return { words: line?.words ?? otherCode(text), problem: true };
    }
    target.current ??= one.title;
    const [arrival] = table.take([one], target.current).arrivals;
    // A code that is seen twice is no news at the end.
    if (arrival && arrival.outcome !== "same") heard.current.push(arrival);
    const words = arrival ? arrivalWords(arrival) : "";
    return one.title === target.current
      ? { words, problem: false }
      : {
          words: `${words} It is another sheet, ${called(one.title)}, with a table of its own.`,
          problem: true,
        };
  };
  const count = target.current === null ? 0 : table.shown.length;
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset has a frame of its own
    <div
      role="group"
      aria-label="Ways to bring in answers"
      class={`${css["part"]} ${css["screen"]}`}
      onDragEnter={keepDrag}
      onDragLeave={keepDrag}
      onDragOver={keepDrag}
      onDrop={(event) => {
        const files = [...(event.dataTransfer?.files ?? [])];
        keepDrag(event);
        if (files.length > 0) void open(files);
      }}
    >
      <p class={layout["hint"]}>
        Scan the QR codes of your pupils, paste their links, words or whole messages, or open files and
        pictures. All may come at once, and they may be dropped here.
      </p>
      <div class={layout["buttons"]}>
        <Button
          kind="primary"
          popup="dialog"
          onClick={() => {
            target.current = null;
            heard.current = [];
            onReport([]);
            setScanning(true);
          }}
        >
          Scan QR codes
        </Button>
        <Button icon="open" onClick={() => input.current?.click()}>
          Open files or pictures
        </Button>
        <input
          ref={input}
          class="unseen"
          type="file"
          multiple
          accept="application/json,.json,image/*,text/*"
          aria-label="Files of answers"
          tabIndex={-1}
          onChange={({ currentTarget }) => {
            const files = [...(currentTarget.files ?? [])];
            if (files.length > 0) void open(files);
            // The same files once more are a choice, too.
            currentTarget.value = "";
          }}
        />
        <span role="status">{busy}</span>
      </div>
      <label class={fieldCss["field"]}>
        Links, words or messages with answers
        <textarea
          rows={2}
          value={typed}
          onInput={({ currentTarget }) => setTyped(currentTarget.value)}
          onPaste={(event) => {
            const { clipboardData } = event;
            const files = [...(clipboardData?.files ?? [])];
            const text = clipboardData?.getData("text/plain") ?? "";
            if (files.length === 0 && (typed !== "" || text === "")) return;
            // It may be a million lines, which no field shows.
            event.preventDefault();
            event.stopPropagation();
            if (files.length > 0) void open(files);
            else openText(text);
          }}
        />
      </label>
      {typed.trim() !== "" && (
        <div class={layout["buttons"]}>
          <Button onClick={() => openText(typed) && setTyped("")}>Add these answers</Button>
        </div>
      )}
      {scanning && (
        <Scan
          onCode={scanned}
          count={size === null ? `${count} handed in` : `${count} of ${size} handed in`}
          size={size}
          onSize={(next) => {
            setSize(next);
            keepClassSize(next);
          }}
          onClose={() => {
            setScanning(false);
            onReport(reportOf(heard.current, target.current ?? ""));
          }}
        />
      )}
    </div>
  );
}

/** Files that are dropped here are answers, and nothing that the studio opens. */
function keepDrag(event: DragEvent): void {
  if (event.dataTransfer?.types.includes("Files") !== true) return;
  event.preventDefault();
  event.stopPropagation();
}

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
