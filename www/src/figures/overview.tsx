import { Cards } from "./cards";
import frameCss from "./kit/frame/frame.module.css";
import layout from "./kit/frame/layout.module.css";
import { ROWS } from "./list";
import css from "./overview.module.css";

/** All figures, each with a small picture that the program made. */
export function Overview({ missing }: { missing: string | null }) {
  return (
    <div class={css["overview"]}>
      <header>
        <h1 tabIndex={-1}>Figures</h1>
        {missing !== null && (
          <p role="status" class={layout["missing"]}>
            There is no figure “{missing}”. Here are those there are.
          </p>
        )}
        <p class={frameCss["figure-lead"]}>
          What four papers show and tell, as pages in which everything moves. If you are new to all this,
          begin with <a href="#learn">the lessons</a>.
        </p>
      </header>
      {ROWS.map((row) => (
        <section key={row.id} aria-labelledby={row.id}>
          <h2 id={row.id}>{row.title}</h2>
          <p class={frameCss["figure-lead"]}>{row.about}</p>
          <Cards figures={row.figures} />
        </section>
      ))}
    </div>
  );
}
