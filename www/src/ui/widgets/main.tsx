/**
 * For developers: every widget in every state, on `/www/widgets.html` of `cargo xtask serve`. No part of the built
 * site.
 */
import "#style/tokens.css";
import "#style/base.css";
import "../panel/panel.css";
import "../panel/progress.css";
import { render } from "preact";
import { useState } from "preact/hooks";
import { Segmented } from "../controls/Segmented";
import { Controls } from "./Controls";
import { Hand } from "./Hand";
import { Orbits } from "./Orbits";
import { Panels } from "./Panels";
import { Shapes } from "./Shapes";
import css from "./widgets.module.css";

const THEMES = [
  { value: "system", label: "System" },
  { value: "light", label: "Light" },
  { value: "dark", label: "Dark" },
] as const;

function Page() {
  const [theme, setTheme] = useState<(typeof THEMES)[number]["value"]>("system");
  document.documentElement.dataset["theme"] = theme;
  return (
    <main class={css["page"]}>
      {/* Else the grid of shapes takes the focus, as it does in its dialog. */}
      <h1 tabIndex={-1} autofocus>
        Widgets
      </h1>
      <a href="../index.html">The studio</a>
      <Segmented label="Theme" options={THEMES} value={theme} onChange={setTheme} />
      {Object.entries({ Controls, Panels, Shapes, Hand, Orbits }).map(([name, Part]) => (
        <section key={name}>
          <h2>{name}</h2>
          <div class={css["widgets"]}>
            <Part />
          </div>
        </section>
      ))}
    </main>
  );
}

render(<Page />, document.body);
