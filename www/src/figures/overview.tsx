import { lazily } from "#ui/lazy";
import frameCss from "./kit/frame/frame.module.css";
import layout from "./kit/frame/layout.module.css";
import { ROWS, type Row } from "./list";
import { thumbOf } from "./loading";
import css from "./overview.module.css";

/** All figures and lessons, each with a small picture that the program made. */
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
      </header>
      {ROWS.map((row) => (
        <section key={row.id} aria-labelledby={row.id}>
          <h2 id={row.id}>{row.title}</h2>
          <p class={frameCss["figure-lead"]}>{row.about}</p>
          <Cards {...row} />
        </section>
      ))}
    </div>
  );
}

/** Small pictures are fetched when they are first shown. */
const THUMBS = new Map(
  ROWS.flatMap(({ figures }) => figures).map((figure) => [figure.id, lazily(() => thumbOf(figure))]),
);

function Cards({ figures }: Row) {
  return (
    <ul class={css["cards"]}>
      {figures.map(({ id, number, title, about }) => {
        const Thumb = THUMBS.get(id);
        return (
          <li key={id}>
            <a class={css["figure-card"]} href={`#figures/${id}`}>
              <span class={css["figure-thumb"]} aria-hidden="true">
                {Thumb && <Thumb />}
              </span>
              <span class={frameCss["figure-number"]}>{number}</span>
              <strong>{title}</strong>
              <span class={css["about"]}>{about}</span>
            </a>
          </li>
        );
      })}
    </ul>
  );
}
