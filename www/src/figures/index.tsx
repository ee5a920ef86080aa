import type { ComponentType } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { Button } from "#ui/controls/Button";
import figuresCss from "./figures.module.css";
import type { Heading } from "./kit/frame/frame";
import { type Figure, find, type Row } from "./list";
import { pageOf } from "./loading";
import { Overview } from "./overview";
import { printLight } from "./print";

/** What stands on the page: the page of a figure, or all figures. */
interface Shown {
  /** As the address has it. */
  name: string | null;
  Page: ComponentType<Heading> | null;
}

/** The figures of the papers and the lessons as live pages: all of them, or the one that the address names. */
export function Figures({ figure: name }: { figure: string | null }) {
  const top = useRef<HTMLDivElement>(null);
  const { shown, problem, retry } = useShown(name);
  const found = shown?.name ? find(shown.name) : null;
  const { figure } = found ?? {};
  const before = useRef<Shown | null>(null);
  useEffect(printLight, []);

  useEffect(() => {
    if (!shown) return;
    document.title = figure ? `${figure.number}: ${figure.title} · Frond` : "Figures · Frond";
    if (before.current !== null && before.current !== shown) {
      // Another page: it is read from its top, and whoever listens hears its name.
      top.current?.closest("main")?.scrollTo({ top: 0 });
      top.current?.querySelector<HTMLElement>("h1")?.focus({ preventScroll: true });
    }
    before.current = shown;
  }, [shown, figure]);

  return (
    <div class={figuresCss["figures"]} ref={top} onPointerOver={fetchAhead} onFocusIn={fetchAhead}>
      {problem !== null && <Unloaded name={name} problem={problem} onTry={retry} />}
      {found && figure && shown?.Page ? (
        <article class={figuresCss["figure"]} aria-busy={shown.name !== name}>
          <TopNav row={found.row} here={figure.id} />
          <shown.Page key={figure.id} number={figure.number} title={figure.title} />
          <NextNav row={found.row} index={found.index} />
        </article>
      ) : (
        shown && <Overview missing={shown.name} />
      )}
    </div>
  );
}

/** What is asked for once it is fetched; what was shown before stays until then. */
function useShown(name: string | null) {
  const [shown, setShown] = useState<Shown | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const [tries, setTries] = useState(0);
  // biome-ignore lint/correctness/useExhaustiveDependencies: each try fetches again
  useEffect(() => {
    let asked = true;
    const figure = name === null ? undefined : find(name)?.figure;
    Promise.resolve(figure ? pageOf(figure) : null).then(
      (Page) => asked && setShown({ name, Page }),
      (reason) => asked && setProblem(wordsOf(reason)),
    );
    return () => {
      asked = false;
      setProblem(null);
    };
  }, [name, tries]);
  return { shown, problem, retry: () => setTries(tries + 1) };
}

/** Whoever comes near a link will soon want its page. */
function fetchAhead({ target }: Event): void {
  const link = target instanceof Element ? target.closest("a[href^='#figures/']") : null;
  const figure = find(link?.getAttribute("href")?.slice("#figures/".length) ?? "")?.figure;
  // A failure is told when the page is asked for.
  if (figure) pageOf(figure).catch(() => undefined);
}

function Unloaded({ name, problem, onTry }: { name: string | null; problem: string; onTry: () => void }) {
  return (
    <div role="alert" class={figuresCss["unloaded"]}>
      <p>
        {find(name ?? "")?.figure.number ?? "The page"} could not be loaded: {problem} Is there a connection?
        Try again, or load the whole page anew.
      </p>
      <Button onClick={onTry}>Try again</Button>
    </div>
  );
}

/** Every page of the same row by its number. */
function TopNav({ row, here }: { row: Row; here: string }) {
  return (
    <nav class={figuresCss["figure-top"]} aria-label={row.name}>
      <a href="#figures">All figures</a>
      <ol>
        {row.figures.map(({ id, number, short }) => (
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
function NextNav({ row: { figures }, index }: { row: Row; index: number }) {
  return (
    <nav class={figuresCss["figure-next"]} aria-label="Before and after">
      <Step figure={figures[index - 1]} rel="prev" />
      <Step figure={figures[index + 1]} rel="next" />
    </nav>
  );
}

function Step({ figure, rel }: { figure: Figure | undefined; rel: "prev" | "next" }) {
  return (
    figure && (
      <a class={rel === "next" ? figuresCss["on"] : undefined} href={`#figures/${figure.id}`} rel={rel}>
        <span>{figure.number}</span>
        {figure.title}
      </a>
    )
  );
}
