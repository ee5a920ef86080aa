import { useState } from "preact/hooks";
import { Button } from "#ui/controls/Button";
import { download, plainName } from "#ui/files/download";
import { Dialog } from "#ui/overlay/Dialog";
import { QrCode } from "#ui/overlay/QrCode";
import fieldCss from "../../../kit/frame/field.module.css";
import layout from "../../../kit/frame/layout.module.css";
import { type Answers, written } from "../answers";
import css from "./hand-in.module.css";
import { waysOf } from "./qr";

interface HandInProps {
  /** Whether there is a name to hand in under. */
  named: boolean;
  /** The answers as they are now. */
  collect: () => Answers;
}

/** What came of it, and what is to be copied by hand where the browser did not. */
interface Told {
  words: string;
  text?: string;
}

/** How a pupil's answers get to the teacher: shown, sent or saved. */
export function HandIn({ named, collect }: HandInProps) {
  const [shown, setShown] = useState<{ name: string; text: string } | null>(null);
  const [told, setTold] = useState<Told | null>(null);
  const ways = () => waysOf(collect(), `${location.origin}${location.pathname}`);
  const show = () => {
    const { qr } = ways();
    setTold(
      qr === null
        ? { words: "You have written more than a QR code can hold. Copy the link, or save a file instead." }
        : null,
    );
    if (qr !== null) setShown({ name: collect().name, text: qr });
  };
  const copy = async (text: string | null, words: string) => {
    if (text === null) {
      setTold({
        words: "You have written more than a link can hold. Copy the word, or save a file instead.",
      });
      return;
    }
    try {
      await navigator.clipboard.writeText(text);
      setTold({ words });
    } catch {
      setTold({ words: "The browser did not allow copying. Select the text below, and copy it.", text });
    }
  };
  const save = () => {
    const answers = collect();
    const file = `answers-${plainName(answers.name, "no-name")}.json`;
    download(new Blob([written(answers)], { type: "application/json" }), file);
    setTold({ words: `Saved as ${file}, where your downloads are. Send this file to your teacher.` });
  };
  return (
    <section class={css["hand-in"]} aria-labelledby="hand-in">
      <h2 id="hand-in">Hand in</h2>
      <p class={layout["hint"]}>
        Choose one way. Your answers go to nobody but the person you show or send them to. If you change
        something later, hand in again: the later answers count.
      </p>
      <div class={layout["buttons"]}>
        <Button kind="primary" disabled={!named} popup="dialog" onClick={show}>
          Show QR code
        </Button>
        <Button
          icon="link"
          disabled={!named}
          onClick={() => void copy(ways().link, "Link copied. Send it to your teacher.")}
        >
          Copy link
        </Button>
        <Button
          icon="copy"
          disabled={!named}
          description="Your answers as one long word, where links are not allowed"
          onClick={() => void copy(ways().word, "Word copied. Paste it into a message to your teacher.")}
        >
          Copy word
        </Button>
        <Button icon="save" disabled={!named} onClick={save}>
          Save as a file
        </Button>
      </div>
      {!named && <p class={layout["hint"]}>Write your name first.</p>}
      <p role="status">{told?.words}</p>
      {told?.text !== undefined && (
        <label class={fieldCss["field"]}>
          To be copied
          <input
            type="text"
            readOnly
            value={told.text}
            onFocus={({ currentTarget }) => currentTarget.select()}
          />
        </label>
      )}
      {shown && (
        <Dialog
          title={shown.name}
          about="Hold this before your teacher’s camera until it shows your name."
          onClose={() => setShown(null)}
        >
          <QrCode address={shown.text} label={`QR code of the answers of ${shown.name}`} large />
        </Dialog>
      )}
    </section>
  );
}
