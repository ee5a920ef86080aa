import "./kit/frame/figures.css";
import "./fujimoto/deform.css";
import "./cochran/fits.css";
import "./lessons/lesson.css";
import "./darwish/spaces.css";
import "./kit/frame/parts.css";
import { useEffect, useRef } from "preact/hooks";
import { DEFORMS, type Entry, FITS, find, LESSONS, SPACES } from "./list";
import { Overview } from "./overview";

/** The figures of the paper and the lessons as live pages: all of them, or the one that the address names. */
export function Figures({ figure }: { figure: string | null }) {
  const top = useRef<HTMLDivElement>(null);
  const found = figure === null ? null : find(figure);
  const entry = found?.row[found.index];
  const before = useRef(figure);

  useEffect(() => {
    document.title = entry ? `${entry.number}: ${entry.title} · Frond` : "Figures · Frond";
    if (before.current === figure) return;
    before.current = figure;
    // Another page: it is read from its top, and whoever listens hears its name.
    top.current?.closest("main")?.scrollTo({ top: 0 });
    top.current?.querySelector<HTMLElement>("h1")?.focus({ preventScroll: true });
  }, [figure, entry]);

  return (
    <div class="figures" ref={top}>
      {found && entry ? (
        <article class="figure">
          <TopNav row={found.row} here={entry.id} />
          <entry.Page key={entry.id} number={entry.number} title={entry.title} />
          <NextNav row={found.row} index={found.index} />
        </article>
      ) : (
        <Overview missing={figure} />
      )}
    </div>
  );
}

function rowName(row: readonly Entry[]): string {
  if (row === LESSONS) return "Lessons";
  if (row === FITS) return "Figures of rough curves";
  if (row === SPACES) return "Figures of space";
  return row === DEFORMS ? "Figures of the deformation" : "Figures";
}

/** Every page of the same row by its number. */
function TopNav({ row, here }: { row: readonly Entry[]; here: string }) {
  return (
    <nav class="figure-top" aria-label={rowName(row)}>
      <a href="#figures">All figures</a>
      <ol>
        {row.map(({ id, number, short }) => (
          <li key={id}>
            <a href={`#figures/${id}`} aria-label={number} aria-current={id === here ? "page" : undefined}>
              {short}
            </a>
          </li>
        ))}
      </ol>
    </nav>
  );
}

/** One back and one on, by name. */
function NextNav({ row, index }: { row: readonly Entry[]; index: number }) {
  const back = row[index - 1];
  const on = row[index + 1];
  return (
    <nav class="figure-next" aria-label="Before and after">
      {back && (
        <a class="back" href={`#figures/${back.id}`} rel="prev">
          <span>{back.number}</span>
          {back.title}
        </a>
      )}
      {on && (
        <a class="on" href={`#figures/${on.id}`} rel="next">
          <span>{on.number}</span>
          {on.title}
        </a>
      )}
    </nav>
  );
}
