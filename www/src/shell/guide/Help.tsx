import { useEffect } from "preact/hooks";
import { type Command, help } from "#ui/commands";
import { Button } from "#ui/controls/Button";
import { ShortcutsDialog } from "#ui/overlay/ShortcutsDialog";
import { WORDS } from "#ui/terms/words";
import { touched } from "#ui/touched";
import css from "./help.module.css";
import * as messages from "./messages";
import { goRound } from "./state";

const close = () => {
  help.value = false;
};

/** What "?" opens: the round, the words, the keys. */
export function Help({ commands }: { commands: () => readonly Command[] }) {
  useEffect(() => {
    // A way out of it was followed.
    addEventListener("hashchange", close);
    return () => removeEventListener("hashchange", close);
  }, []);
  return (
    <ShortcutsDialog commands={commands}>
      <p class={css["first"]}>
        <Button onClick={goRound}>{messages.takeTour}</Button>
        <a class={`button ${css["learn"]}`} href="#learn">
          {messages.learnFromBeginning}
        </a>
      </p>
      <details class={css["words"]} open={touched.value}>
        <summary>{messages.glossary}</summary>
        <dl>
          {WORDS.map(({ word, means, lesson }) => (
            <div key={word}>
              <dt>{word}</dt>
              <dd>
                {means}{" "}
                {lesson && (
                  <a href={`#learn/${lesson}`} aria-label={messages.lessonOn(word)}>
                    {messages.lesson}
                  </a>
                )}
              </dd>
            </div>
          ))}
        </dl>
      </details>
    </ShortcutsDialog>
  );
}
