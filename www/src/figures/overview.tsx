import { lazily } from "#ui/lazy";
import { ROWS, type Row } from "./list";
import { thumbOf } from "./loading";

/** All figures and lessons, each with a small picture that the program made. */
export function Overview({ missing }: { missing: string | null }) {
  return (
    <div class="overview">
      <header>
        <h1 tabIndex={-1}>Figures</h1>
        {missing !== null && (
          <p role="status" class="missing">
            There is no figure “{missing}”. Here are those there are.
          </p>
        )}
      </header>
      {ROWS.map((row) => (
        <section key={row.id} aria-labelledby={row.id}>
          <h2 id={row.id}>{row.title}</h2>
          <p class="figure-lead">{row.about}</p>
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
    <ul class="cards">
      {figures.map(({ id, number, title, about }) => {
        const Thumb = THUMBS.get(id);
        return (
          <li key={id}>
            <a class="figure-card" href={`#figures/${id}`}>
              <span class="figure-thumb" aria-hidden="true">
                {Thumb && <Thumb />}
              </span>
              <span class="figure-number">{number}</span>
              <strong>{title}</strong>
              <span class="about">{about}</span>
            </a>
          </li>
        );
      })}
    </ul>
  );
}
