import { CATALOGUE } from "./catalogue";

/** All figures, each with a small picture that the program made. */
export function Overview({ missing }: { missing: string | null }) {
  return (
    <div class="overview">
      <header>
        <h1 tabIndex={-1}>Figures</h1>
        <p class="figure-lead">
          The figures and the table of “Linear Fractal Shape Interpolation” by Brandon Burch and John C. Hart
          (Graphics Interface 1997), as pages in which everything moves. All of it is computed here, while you
          look.
        </p>
        {missing !== null && (
          <p role="status" class="missing">
            There is no figure “{missing}”. Here are those there are.
          </p>
        )}
      </header>
      <ul class="cards">
        {CATALOGUE.map(({ id, number, title, about, Thumb }) => (
          <li key={id}>
            <a class="figure-card" href={`#figures/${id}`}>
              <span class="figure-thumb" aria-hidden="true">
                <Thumb />
              </span>
              <span class="figure-number">{number}</span>
              <strong>{title}</strong>
              <span class="about">{about}</span>
            </a>
          </li>
        ))}
      </ul>
    </div>
  );
}
