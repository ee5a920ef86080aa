import type { ComponentChildren } from "preact";
import { type Command, groupsOf, help } from "../commands";
import { touched } from "../touched";
import { Dialog } from "./Dialog";
import "./overlay.css";
import * as messages from "../messages";
import css from "./overlay.module.css";

interface ShortcutsProps {
  commands: () => readonly Command[];
  /** What helps besides, above them. */
  children?: ComponentChildren;
}

const NUMBERS = messages.inNumberFieldsAnd;

/** The keys of a tool, opened by "?" or by a button. Below what else helps they are folded away from fingers. */
export function ShortcutsDialog({ commands, children }: ShortcutsProps) {
  if (!help.value) return null;
  const folded = touched.value && children !== undefined;
  return (
    <Dialog
      reading
      title={children === undefined ? messages.keyboard : messages.help}
      {...(folded ? {} : { about: NUMBERS })}
      onClose={() => {
        help.value = false;
      }}
    >
      {children}
      {folded ? (
        <details class={css["keys"]}>
          <summary>{messages.keyboard}</summary>
          <p class="hint">{NUMBERS}</p>
          <Keys commands={commands} />
        </details>
      ) : (
        <Keys commands={commands} />
      )}
      <p class="hint">
        <a href="./licenses.txt" target="_blank" rel="noreferrer">
          {messages.licencesFrondAndComponents}
        </a>
      </p>
    </Dialog>
  );
}

function Keys({ commands }: Pick<ShortcutsProps, "commands">) {
  return (
    <div class={css["shortcuts"]}>
      {groupsOf(commands()).map((group) => (
        <section key={group.title}>
          <h3>{group.title}</h3>
          <dl>
            {group.commands.map(({ id, label, keys }) => (
              <div key={id} class={css["shortcut"]}>
                <dt>
                  {keys.map((way, index) => (
                    <span key={way}>
                      {index > 0 && <span class={css["or"]}> {messages.or} </span>}
                      {/* "+" alone is a key. */}
                      {way.split(/(?<=.)\+/).map((key) => (
                        <kbd key={key}>{key}</kbd>
                      ))}
                    </span>
                  ))}
                </dt>
                <dd>{label}</dd>
              </div>
            ))}
          </dl>
        </section>
      ))}
    </div>
  );
}
