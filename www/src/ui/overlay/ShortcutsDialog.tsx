import type { ComponentChildren } from "preact";
import { type Command, groupsOf, help } from "../commands";
import { Dialog } from "./Dialog";
import "./overlay.css";
import css from "./overlay.module.css";

interface ShortcutsProps {
  commands: () => readonly Command[];
  /** What helps besides, above them. */
  children?: ComponentChildren;
}

/** The keys of a tool, opened by "?" or by a button. */
export function ShortcutsDialog({ commands, children }: ShortcutsProps) {
  if (!help.value) return null;
  return (
    <Dialog
      reading
      title={children === undefined ? "Keyboard" : "Help"}
      about="In number fields: ↑ and ↓ step, Shift finer, Alt coarser."
      onClose={() => {
        help.value = false;
      }}
    >
      {children}
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
                        {index > 0 && <span class={css["or"]}> or </span>}
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
      <p class="hint">
        <a href="./licenses.txt" target="_blank" rel="noreferrer">
          Licences of Frond and its parts
        </a>
      </p>
    </Dialog>
  );
}
