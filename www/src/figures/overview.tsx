import { signal } from "@preact/signals";
import { Button } from "#ui/controls/Button";
import { Cards } from "./cards";
import type { Row } from "./figure";
import { Find } from "./find/Find";
import frameCss from "./kit/frame/frame.module.css";
import layout from "./kit/frame/layout.module.css";
import { useValue } from "./kit/workers";
import { ROWS } from "./list";
import css from "./overview.module.css";
import { Sections } from "./papers/Sections";
import { figuresFound, sectionsFound, sectionsOf } from "./papers/sections";

/** What is looked for; it is there again on the way back from a figure. */
const asked = signal("");
/** The papers whose sections are shown, as well. */
const unfolded = signal<ReadonlySet<string>>(new Set());

/** All figures, each with a small picture that the program made, and the papers section by section. */
export function Overview({ missing }: { missing: string | null }) {
  const words = useValue(asked);
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
        <Find
          label="Find a figure or a section of a paper"
          example="Darwish 3.6, Table 1, Theorem 2 …"
          value={words}
          onChange={(next) => {
            asked.value = next;
          }}
        />
      </header>
      {words.trim() === "" ? <Papers /> : <Found words={words} />}
    </div>
  );
}

function Papers() {
  return (
    <>
      <nav class={css["papers"]} aria-label="Papers">
        {ROWS.map((row) => (
          <button key={row.id} type="button" class="button" onClick={() => goTo(row.id)}>
            {row.paper}
          </button>
        ))}
      </nav>
      {ROWS.map((row) => (
        <section key={row.id} aria-labelledby={row.id}>
          <h2 id={row.id} tabIndex={-1}>
            {row.title}
          </h2>
          <p class={frameCss["figure-lead"]}>{row.about}</p>
          <BySection row={row} />
          <Cards figures={row.figures} />
        </section>
      ))}
    </>
  );
}

function goTo(id: string): void {
  const heading = document.getElementById(id);
  heading?.scrollIntoView();
  heading?.focus({ preventScroll: true });
}

/** What shows each section of a paper, for whoever has it in hand. */
function BySection({ row }: { row: Row }) {
  const open = useValue(unfolded).has(row.id);
  return (
    <details
      class={css["by-section"]}
      open={open}
      onToggle={({ currentTarget }) => {
        const next = new Set(unfolded.peek());
        if (currentTarget.open) next.add(row.id);
        else next.delete(row.id);
        unfolded.value = next;
      }}
    >
      <summary>{row.paper}, section by section</summary>
      <Sections row={row} sections={sectionsOf(row)} />
    </details>
  );
}

function Found({ words }: { words: string }) {
  const figures = figuresFound(words);
  const papers = sectionsFound(words);
  const count = papers.reduce((sum, { sections }) => sum + sections.length, 0);
  return (
    <section aria-label="Figures and sections found">
      <p role="status">
        {count + figures.length === 0
          ? `Nothing here says “${words.trim()}”. Try an author, the number of a section, or another word.`
          : `${many(count, "section")} and ${many(figures.length, "figure")} with “${words.trim()}”.`}
      </p>
      {papers.map(({ row, sections }) => (
        <section key={row.id} aria-labelledby={`found-${row.id}`}>
          <h2 id={`found-${row.id}`}>{row.paper}</h2>
          <Sections row={row} sections={sections} />
        </section>
      ))}
      <Cards figures={figures} />
      <div>
        <Button
          onClick={() => {
            asked.value = "";
          }}
        >
          Show all figures
        </Button>
      </div>
    </section>
  );
}

const many = (count: number, what: string) =>
  `${count === 0 ? "no" : count} ${what}${count === 1 ? "" : "s"}`;
