import "./overlay.css";
export interface ShortcutRow {
  /** Each is one way to press it, such as ["Ctrl", "Z"]. */
  keys: readonly (readonly string[])[];
  does: string;
}

/** Keys and what they do, in groups. */
export function ShortcutTable({
  groups,
}: {
  groups: readonly { title: string; rows: readonly ShortcutRow[] }[];
}) {
  return (
    <div class="shortcuts">
      {groups.map((group) => (
        <section key={group.title}>
          <h3>{group.title}</h3>
          <dl>
            {group.rows.map((row) => (
              <div key={row.does} class="shortcut">
                <dt>
                  {row.keys.map((way, index) => (
                    <span key={way.join("+")}>
                      {index > 0 && <span class="or"> or </span>}
                      {way.map((key) => (
                        <kbd key={key}>{key}</kbd>
                      ))}
                    </span>
                  ))}
                </dt>
                <dd>{row.does}</dd>
              </div>
            ))}
          </dl>
        </section>
      ))}
    </div>
  );
}
