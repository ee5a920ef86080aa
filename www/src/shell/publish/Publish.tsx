import { useEffect, useRef, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import { endsOf } from "#document/stand-in";
import type { FilmSubject, Still } from "#film/subject";
import { folderAddress } from "#format/html";
import { Button } from "#ui/controls/Button";
import { download, plainName } from "#ui/files/download";
import { Dialog } from "#ui/overlay/Dialog";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { filmTask } from "#workers/film/client";
import { openedTool } from "../tools";
import type { Moves } from "./folder";
import { type FilmChoice, makeFolder, mp4Settings } from "./make";
import * as messages from "./messages";
import css from "./publish.module.css";
import shareCss from "./share.module.css";

interface PublishProps {
  /** The link that is published. */
  address: string;
  moves: Moves;
  still: () => Promise<Still>;
  onClose: () => void;
}

/** An address as people may write it. */
const EXAMPLE = "https://example.org/fern/";

const WRONG = messages.enterAddressBeginsWith;

/** Asks what the folder says of itself, and makes it. */
export function Publish({ address, moves, still, onClose }: PublishProps) {
  const [title, setTitle] = useState(titleNow);
  const [about, setAbout] = useState(messages.liveFractalMadeWith);
  const [home, setHome] = useState("");
  const [film, setFilm] = useState<FilmChoice>("none");
  const [subjects, setSubjects] = useState<readonly FilmSubject[]>([]);
  const [mp4, setMp4] = useState(false);
  const [told, setTold] = useState("");
  const [busy, setBusy] = useState(false);
  const stop = useRef<AbortController | null>(null);
  useEffect(() => {
    void openedTool()
      .tool?.films?.()
      .then(
        ({ subjects }) => setSubjects(subjects),
        () => {},
      );
    if (typeof VideoEncoder !== "undefined")
      void filmTask("encodable", mp4Settings()).then(
        (able) => setMp4(able.mp4),
        () => {},
      );
    return () => stop.current?.abort();
  }, []);
  const whole = home.trim() === "" ? null : folderAddress(home.trim());
  const wrong = home.trim() !== "" && whole === null;

  const make = async () => {
    const ending = new AbortController();
    stop.current = ending;
    setBusy(true);
    try {
      const words = {
        title: title.trim() || messages.fractal,
        about: about.trim(),
        address,
        home: whole,
        moves,
      };
      const zip = await makeFolder({ ...words, film }, await still(), subjects, ending.signal, setTold);
      download(new Blob([zip], { type: "application/zip" }), `${plainName(words.title, "frond")}.zip`);
      setTold(messages.savedUnpackZipAnd);
    } catch (problem) {
      setTold(ending.signal.aborted ? "" : messages.publishingFailed(wordsOf(problem)));
    } finally {
      setBusy(false);
    }
  };

  return (
    <Dialog title={messages.publish2} about={messages.readyMadeWebPageZip} onClose={onClose}>
      <form
        class={shareCss["share"]}
        onSubmit={(event) => {
          event.preventDefault();
          if (!busy && !wrong) void make();
        }}
      >
        <Field label={messages.title} value={title} onInput={setTitle} />
        <Field label={messages.description} value={about} onInput={setAbout} />
        <Field
          label={messages.addressOptional}
          value={home}
          placeholder={EXAMPLE}
          hint={wrong ? WRONG : messages.pagesFullAddressMessengers}
          wrong={wrong}
          onInput={setHome}
        />
        {subjects.length > 0 && (
          <ChoiceRow
            label={messages.film}
            options={[
              { value: "none", label: messages.none },
              { value: "gif", label: "GIF" },
              ...(mp4 ? [{ value: "mp4" as const, label: "MP4" }] : []),
            ]}
            value={film}
            onChange={setFilm}
          />
        )}
        <footer class={css["publish-foot"]}>
          <p class="hint" role="status">
            {told}
          </p>
          {busy ? (
            <Button onClick={() => stop.current?.abort()}>{messages.cancel}</Button>
          ) : (
            <Button kind="primary" icon="save" disabled={wrong} onClick={() => void make()}>
              {messages.saveFolderZip}
            </Button>
          )}
        </footer>
      </form>
    </Dialog>
  );
}

interface FieldProps {
  label: string;
  value: string;
  placeholder?: string;
  hint?: string;
  wrong?: boolean;
  onInput: (text: string) => void;
}

/** Letters of a title or a description, at most. */
const MOST_LETTERS = 300;

function Field({ label, value, placeholder, hint, wrong = false, onInput }: FieldProps) {
  return (
    <label class={css["publish-field"]}>
      <span class="field-label">{label}</span>
      <input
        class={shareCss["address"]}
        value={value}
        maxLength={MOST_LETTERS}
        aria-invalid={wrong}
        {...(placeholder === undefined ? {} : { placeholder })}
        onInput={(event) => onInput(event.currentTarget.value)}
      />
      {hint !== undefined && <span class={wrong ? "field-problem" : "hint"}>{hint}</span>}
    </label>
  );
}

function titleNow(): string {
  const { tool } = scene.peek();
  const { a, b } = endsOf(scene.peek());
  if (tool === "space") return messages.fractalInSpace;
  if (tool === "fit") return messages.fractalCurve;
  return a.name === b.name ? a.name : messages.to(a.name, b.name);
}
