import { useContext, useEffect, useMemo, useState } from "preact/hooks";
import { cameFrom } from "#document/kept/sheet";
import { presets } from "#document/presets";
import { Button, IconButton } from "#ui/controls/Button";
import { QrCode } from "#ui/overlay/QrCode";
import fieldCss from "../../kit/frame/field.module.css";
import frameCss from "../../kit/frame/frame.module.css";
import layout from "../../kit/frame/layout.module.css";
import { preset } from "../../kit/frame/studio-link";
import { Fitted } from "../../kit/picture/fitted";
import { Page } from "../../kit/state/kept";
import { toTop } from "../../kit/state/steps";
import { LESSONS } from "../course";
import css from "./class.module.css";
import { Handed } from "./handed/handed";
import { draft, keepDraft } from "./kept";
import { Lessons } from "./lessons";
import { itemsWithNames, plainLinkName } from "./names";
import {
  EMPTY,
  fits,
  itemsOf,
  linkItem,
  linksIn,
  MOST,
  moved,
  numbered,
  type Sheet,
  sheetAddress,
  sheetIn,
  sheetOfLink,
} from "./sheet";

/** Where a teacher makes a sheet for a class, and opens what comes back. */
export function Teacher() {
  const { state } = useContext(Page);
  const link = /^answers(?:=|%3D)/i.test(state) ? state : null;
  // Who makes sheets has come back from them.
  useEffect(() => cameFrom(null), []);
  const handed = <Handed link={link} draft={draftTitle()} />;
  return (
    <div class={css["page"]}>
      <p class={css["screen"]}>
        <a href="#learn">All lessons</a>
      </p>
      <h1 tabIndex={-1}>Class sheet</h1>
      <p class={`${frameCss["figure-lead"]} ${css["screen"]}`}>
        Choose what your class is to do, and send one link. Pupils work in their own browsers, without an
        account; they hand in by a QR code, a link or a file, and you collect the answers here. Nothing is
        sent anywhere.
      </p>
      {link === null && (
        <div class={css["screen"]}>
          <Button icon="down" onClick={toAnswers}>
            Collect answers
          </Button>
        </div>
      )}
      {/* Who opens the link of a pupil wants to see that. */}
      {link !== null && handed}
      <Make />
      {link === null && handed}
    </div>
  );
}

/** Past all the lessons that could be chosen, which on a telephone are many screens. */
function toAnswers(): void {
  const heading = document.getElementById("handed");
  if (!heading) return;
  toTop(heading);
  heading.focus({ preventScroll: true });
}

/** The title of the sheet in the making; null where there is none. */
function draftTitle(): string | null {
  const sheet = draft();
  return itemsOf(sheet).length === 0 ? null : sheet.title.trim();
}

function Make() {
  const { state } = useContext(Page);
  const [known, setKnown] = useState(() => new Map<string, number>());
  const [sheet, showSheet] = useState<Sheet>(() => cleaned(sheetIn(state)?.sheet ?? draft(), known));
  const [pasted, showPasted] = useState(() => linesOf(sheet));
  const [folded, setFolded] = useState(sheet.shapes.length + sheet.links.length === 0);
  const { wrong } = useMemo(() => linksIn(pasted), [pasted]);
  const count = itemsOf(sheet).length;
  const setSheet = (next: Sheet) => {
    showSheet(next);
    keepDraft(next);
  };
  const setPasted = (next: string) => {
    showPasted(next);
    setSheet({ ...sheet, ...numbered(sheet, linksIn(next).links, known) });
  };
  const open = (other: Sheet) => {
    const numbers = new Map<string, number>();
    const next = cleaned(other, numbers);
    setKnown(numbers);
    setSheet(next);
    showPasted(linesOf(next));
    setFolded(next.shapes.length + next.links.length === 0);
  };
  const toggle = (part: "lessons" | "shapes", order: readonly string[], id: string) => {
    const chosen = sheet[part].includes(id) ? sheet[part].filter((one) => one !== id) : [...sheet[part], id];
    setSheet({ ...sheet, [part]: order.filter((one) => chosen.includes(one)) });
  };
  const lessons = LESSONS.map(({ id }) => id);
  const shapes = presets().map(({ id }) => id);
  return (
    <section class={`${css["part"]} ${css["make"]}`} aria-labelledby="make">
      <h2 id="make">Make a sheet</h2>
      <OpenSheet onOpen={open} onClear={count > 0 ? () => open(EMPTY) : null} />
      <label class={fieldCss["field"]}>
        Its title
        <input
          type="text"
          maxLength={MOST.title}
          value={sheet.title}
          onInput={({ currentTarget }) => setSheet({ ...sheet, title: currentTarget.value })}
        />
      </label>
      <Lessons chosen={sheet.lessons} onToggle={(id) => toggle("lessons", lessons, id)} />
      <details open={!folded} onToggle={({ currentTarget }) => setFolded(!currentTarget.open)}>
        <summary>Shapes of the gallery, and links of your own</summary>
        <div class={css["part"]}>
          <fieldset class={css["shapes"]}>
            <legend class="unseen">Shapes</legend>
            {(folded ? [] : presets()).slice(0, MOST.shapes).map(({ id, name }) => (
              <label key={id} class={css["tick"]}>
                <input
                  type="checkbox"
                  checked={sheet.shapes.includes(id)}
                  onChange={() => toggle("shapes", shapes, id)}
                />
                <span class={css["small"]} aria-hidden="true">
                  <Fitted of={preset(id).maps} />
                </span>
                {name}
              </label>
            ))}
          </fieldset>
          <label class={fieldCss["field"]}>
            Links that you have copied, from a step of a lesson or from the studio, one to a line
            <textarea
              rows={3}
              value={pasted}
              onInput={({ currentTarget }) => setPasted(currentTarget.value)}
            />
          </label>
          {sheet.links.map((link, i) => {
            const number = sheet.numbers[i] ?? i + 1;
            const key = linkItem(number);
            return (
              <label key={key} class={fieldCss["field"]}>
                What your class sees link {number} called
                <input
                  type="text"
                  maxLength={MOST.name}
                  placeholder={plainLinkName(link, number)}
                  value={sheet.names[key] ?? ""}
                  onInput={({ currentTarget }) =>
                    setSheet({ ...sheet, names: { ...sheet.names, [key]: currentTarget.value } })
                  }
                />
              </label>
            );
          })}
          {wrong.length > 0 && (
            <p role="status" class={layout["missing"]}>
              {wrong.length === 1 ? "One line is" : `${wrong.length} lines are`} left out: no link of Frond,
              too long, or more than {MOST.links}.
            </p>
          )}
        </div>
      </details>
      {count > 0 && <Tasks sheet={sheet} onChange={setSheet} />}
      {count > 0 && (
        <div>
          <label class={css["tick"]}>
            <input
              type="checkbox"
              checked={sheet.hide}
              onChange={({ currentTarget }) => setSheet({ ...sheet, hide: currentTarget.checked })}
            />
            Lessons do not say yet whether a guess is right
          </label>
          {sheet.hide && (
            <p class={layout["hint"]}>
              The guesses reach you all the same. Once all have handed in, give your class the other link,
              which shows what is right: what they wrote is there again. Exercises say as ever when they are
              solved.
            </p>
          )}
        </div>
      )}
      {count === 0 ? (
        <p class={layout["hint"]}>Choose a lesson, and the link stands here.</p>
      ) : !fits(sheet) ? (
        <p role="status" class={layout["missing"]}>
          This is more than one link can hold. Take some of it off, or write less.
        </p>
      ) : (
        <>
          <Given
            address={addressOf(sheet)}
            later={sheet.hide ? addressOf({ ...sheet, hide: false }) : null}
            count={count}
          />
          <AtHand address={addressOf(sheet)} words={sizeWords(sheet)} />
        </>
      )}
    </section>
  );
}

interface TasksProps {
  sheet: Sheet;
  onChange: (sheet: Sheet) => void;
}

/** What is to be done, in its order, each with the teacher's own words. */
function Tasks({ sheet, onChange }: TasksProps) {
  const [said, setSaid] = useState("");
  const items = itemsWithNames(sheet);
  const move = (key: string, name: string, by: number) => {
    const next = moved(sheet, key, by);
    onChange(next);
    setSaid(`${name} is number ${itemsOf(next).indexOf(key) + 1} of ${items.length}.`);
    // The button that was pressed goes along, and stays in sight.
    requestAnimationFrame(() => document.activeElement?.scrollIntoView({ block: "nearest" }));
  };
  return (
    <fieldset class={css["part"]}>
      <legend>What is to be done, in its order, and in your own words where you like</legend>
      <ol class={css["tasks"]}>
        {items.map(({ key, name }, i) => (
          <li key={key}>
            <span class="number" aria-hidden="true">
              {i + 1}.
            </span>
            <label class={fieldCss["field"]}>
              {name}
              <input
                type="text"
                maxLength={MOST.task}
                value={sheet.tasks[key] ?? ""}
                onInput={({ currentTarget }) =>
                  onChange({ ...sheet, tasks: { ...sheet.tasks, [key]: currentTarget.value } })
                }
              />
            </label>
            {/* At the ends they do nothing, and keep the focus. */}
            <IconButton
              icon="up"
              kind="quiet"
              label={`Move up: ${name}`}
              onClick={() => move(key, name, -1)}
            />
            <IconButton
              icon="down"
              kind="quiet"
              label={`Move down: ${name}`}
              onClick={() => move(key, name, 1)}
            />
          </li>
        ))}
      </ol>
      <p role="status" class="unseen">
        {said}
      </p>
    </fieldset>
  );
}

/** How much there is to do, and about how long its lessons take. */
function sizeWords(sheet: Sheet): string {
  const count = itemsOf(sheet).length;
  const minutes = LESSONS.filter(({ id }) => sheet.lessons.includes(id)).reduce(
    (sum, lesson) => sum + lesson.minutes,
    0,
  );
  return `${count} ${count === 1 ? "thing" : "things"} to do${minutes > 0 ? `, ${minutes} minutes and the exercises` : ""}`;
}

/** A sheet with those of its links that are such. */
const cleaned = (sheet: Sheet, known: Map<string, number>): Sheet => ({
  ...sheet,
  ...numbered(sheet, linksIn(linesOf(sheet)).links, known),
});

/** Links of a sheet as one would have pasted them. */
const linesOf = ({ links }: Sheet) =>
  links.map((link) => `${location.origin}${location.pathname}#${link}`).join("\n");

/** A sheet that was made before is opened from its link. */
function OpenSheet({ onOpen, onClear }: { onOpen: (sheet: Sheet) => void; onClear: (() => void) | null }) {
  const [link, setLink] = useState("");
  const found = useMemo(() => sheetOfLink(link), [link]);
  return (
    <details>
      <summary>Change a sheet that you have made before, or begin anew</summary>
      <div class={css["part"]}>
        <label class={fieldCss["field"]}>
          To change a sheet that you have made before, paste its link
          <input type="text" value={link} onInput={({ currentTarget }) => setLink(currentTarget.value)} />
        </label>
        <div class={layout["buttons"]}>
          {link !== "" && (
            <Button
              disabled={!found}
              onClick={() => {
                if (found) onOpen(found);
                setLink("");
              }}
            >
              Open this sheet
            </Button>
          )}
          {onClear && (
            <Button kind="quiet" icon="reset" onClick={onClear}>
              Begin with an empty sheet
            </Button>
          )}
          {link !== "" && !found && <p class={layout["hint"]}>This is no link of a class sheet.</p>}
        </div>
      </div>
    </details>
  );
}

const addressOf = (sheet: Sheet) =>
  `${location.origin}${location.pathname}#learn/sheet/${sheetAddress(sheet)}`;

/** Copies the link, and says whether it did; what was said of another link is gone. */
function useCopy(address: string): [copy: () => void, said: string] {
  const [told, setTold] = useState<{ of: string; words: string } | null>(null);
  const copy = () =>
    void navigator.clipboard.writeText(address).then(
      () => setTold({ of: address, words: "Copied." }),
      () => setTold({ of: address, words: "Copying was not allowed here: choose the link, and copy it." }),
    );
  return [copy, told?.of === address ? told.words : ""];
}

/** What is always in sight while a sheet is made: how much it is, and its link. */
function AtHand({ address, words }: { address: string; words: string }) {
  const [copy, said] = useCopy(address);
  return (
    <div class={css["at-hand"]}>
      <span aria-live="polite">{said === "" ? words : said}</span>
      <Button kind="primary" icon="copy" onClick={copy}>
        Copy the link
      </Button>
    </div>
  );
}

interface GivenProps {
  address: string;
  /** The link that shows answers, where this one hides them. */
  later: string | null;
  count: number;
}

function Given({ address, later, count }: GivenProps) {
  const [copy, said] = useCopy(address);
  const [copyLater, saidLater] = useCopy(later ?? "");
  return (
    <div class={css["given"]}>
      <div class={css["part"]}>
        <label class={fieldCss["field"]}>
          The link of this sheet, with {count} {count === 1 ? "thing" : "things"} to do
          <input
            type="text"
            readOnly
            value={address}
            onFocus={({ currentTarget }) => currentTarget.select()}
          />
        </label>
        <div class={layout["buttons"]}>
          <Button kind="primary" icon="copy" onClick={copy}>
            Copy
          </Button>
          <a class="button" href={address}>
            See it as your class does
          </a>
          {later !== null && (
            <Button icon="copy" onClick={copyLater}>
              Copy the link that shows answers
            </Button>
          )}
          <span role="status">{said || (later === null ? "" : saidLater)}</span>
        </div>
      </div>
      <QrCode address={address} />
    </div>
  );
}
