import { useMemo, useState } from "preact/hooks";
import { presets } from "#document/presets";
import { Button } from "#ui/controls/Button";
import { QrCode } from "#ui/overlay/QrCode";
import frameCss from "../../kit/frame/frame.module.css";
import layout from "../../kit/frame/layout.module.css";
import { UNITS } from "../course";
import css from "./class.module.css";
import { Handed } from "./handed";
import { EMPTY, itemsOf, linksIn, MOST, type Sheet, sheetAddress } from "./sheet";

/** Where a teacher makes a sheet for a class, and opens what comes back. */
export function Teacher() {
  return (
    <div class={css["page"]}>
      <p>
        <a href="#learn">All lessons</a>
      </p>
      <h1 tabIndex={-1}>Class sheet</h1>
      <p class={frameCss["figure-lead"]}>
        Choose what your class is to do, and send one link. Pupils work in their own browsers, without an
        account; they save their answers as a file, and you open the files here. Nothing is sent anywhere.
      </p>
      <Make />
      <Handed />
    </div>
  );
}

function Make() {
  const [sheet, setSheet] = useState<Sheet>(EMPTY);
  const [pasted, setPasted] = useState("");
  const { links, wrong } = useMemo(() => linksIn(pasted), [pasted]);
  const whole = { ...sheet, links };
  const count = itemsOf(whole).length;
  const toggle = (part: "lessons" | "shapes", order: readonly string[], id: string) => {
    const chosen = sheet[part].includes(id) ? sheet[part].filter((one) => one !== id) : [...sheet[part], id];
    setSheet({ ...sheet, [part]: order.filter((one) => chosen.includes(one)) });
  };
  const lessons = UNITS.flatMap(({ figures }) => figures.map(({ id }) => id));
  const shapes = presets().map(({ id }) => id);
  return (
    <section class={css["part"]} aria-labelledby="make">
      <h2 id="make">Make a sheet</h2>
      <label class={css["field"]}>
        Its title
        <input
          type="text"
          maxLength={MOST.title}
          value={sheet.title}
          onInput={({ currentTarget }) => setSheet({ ...sheet, title: currentTarget.value })}
        />
      </label>
      <div class={css["units"]}>
        {UNITS.map(({ id, title, figures }) => (
          <fieldset key={id}>
            <legend>{title}</legend>
            {figures.map((lesson) => (
              <label key={lesson.id} class={css["tick"]}>
                <input
                  type="checkbox"
                  checked={sheet.lessons.includes(lesson.id)}
                  onChange={() => toggle("lessons", lessons, lesson.id)}
                />
                {lesson.title}
              </label>
            ))}
          </fieldset>
        ))}
      </div>
      <details>
        <summary>Shapes of the gallery, and links of your own</summary>
        <div class={css["part"]}>
          <fieldset class={css["shapes"]}>
            <legend class="unseen">Shapes</legend>
            {presets()
              .slice(0, MOST.shapes)
              .map(({ id, name }) => (
                <label key={id} class={css["tick"]}>
                  <input
                    type="checkbox"
                    checked={sheet.shapes.includes(id)}
                    onChange={() => toggle("shapes", shapes, id)}
                  />
                  {name}
                </label>
              ))}
          </fieldset>
          <label class={css["field"]}>
            Links that you have copied, from a step of a lesson or from the studio, one to a line
            <textarea
              rows={3}
              value={pasted}
              onInput={({ currentTarget }) => setPasted(currentTarget.value)}
            />
          </label>
          {wrong.length > 0 && (
            <p role="status" class={layout["missing"]}>
              {wrong.length === 1 ? "One line is" : `${wrong.length} lines are`} left out: no link of Frond,
              too long, or more than {MOST.links}.
            </p>
          )}
        </div>
      </details>
      {count === 0 ? (
        <p class={layout["hint"]}>Choose a lesson, and the link stands here.</p>
      ) : (
        <Given address={addressOf(whole)} count={count} />
      )}
    </section>
  );
}

const addressOf = (sheet: Sheet) =>
  `${location.origin}${location.pathname}#learn/sheet/${sheetAddress(sheet)}`;

function Given({ address, count }: { address: string; count: number }) {
  const [told, setTold] = useState<{ of: string; words: string } | null>(null);
  const copy = () =>
    navigator.clipboard.writeText(address).then(
      () => setTold({ of: address, words: "Copied." }),
      () => setTold({ of: address, words: "Copying was not allowed here: choose the link, and copy it." }),
    );
  return (
    <div class={css["given"]}>
      <div class={css["part"]}>
        <label class={css["field"]}>
          The link of this sheet, with {count} {count === 1 ? "thing" : "things"} to do
          <input
            type="text"
            readOnly
            value={address}
            onFocus={({ currentTarget }) => currentTarget.select()}
          />
        </label>
        <div class={layout["buttons"]}>
          <Button kind="primary" icon="copy" onClick={() => void copy()}>
            Copy
          </Button>
          <a class="button" href={address}>
            See it as your class does
          </a>
          <span role="status">{told?.of === address ? told.words : ""}</span>
        </div>
      </div>
      <QrCode address={address} />
    </div>
  );
}
