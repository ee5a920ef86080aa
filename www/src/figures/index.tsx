import type { ComponentType } from "preact";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { sheetBehind } from "#document/kept/sheet";
import type { Place } from "#document/link";
import { notify, wordsOf } from "#document/notice";
import { Button } from "#ui/controls/Button";
import type { Figure, Row } from "./figure";
import figuresCss from "./figures.module.css";
import type { Heading } from "./kit/frame/frame";
import { printLight } from "./kit/frame/print";
import { copySelection } from "./kit/notation/copy";
import { Page as PageOf } from "./kit/state/kept";
import { PageState } from "./kit/state/page-state";
import { openedStep, showStep } from "./kit/state/steps";
import { Contents } from "./lessons/contents";
import { find, hrefOf, lessonOf, neighbours, related } from "./list";
import { pageOf } from "./loading";
import { Overview } from "./overview";
import { sectionWith } from "./papers/sections";

/** What stands on the page: the page of a figure or a lesson, or all of them. */
interface Shown {
  place: Place["page"];
  /** As the address has it. */
  name: string | null;
  state: string;
  Page: ComponentType<Heading> | null;
}

interface FiguresProps extends Omit<Place, "page"> {
  place: Place["page"];
}

const TITLES = { figures: "Figures", learn: "Learn" };

/** Pages of the course that are no lessons. */
const CLASS: Record<string, () => Promise<ComponentType<Heading>>> = {
  class: () => import("./lessons/class/teacher").then(({ Teacher }) => Teacher as ComponentType<Heading>),
  sheet: () => import("./lessons/class/pupil").then(({ Pupil }) => Pupil as ComponentType<Heading>),
};
const isClass = (place: Place["page"], name: string | null): name is string =>
  place === "learn" && name !== null && Object.hasOwn(CLASS, name);

/** The figures of the papers and the lessons as live pages: all of them, or the one that the address names. */
export function Figures({ place, figure: name, state }: FiguresProps) {
  const top = useRef<HTMLDivElement>(null);
  const { shown, problem, retry } = useShown(place, name, state);
  const found = shown?.name ? find(shown.name) : null;
  const { figure } = found ?? {};
  const page = useMemo(() => {
    const place = figure
      ? hrefOf(figure).slice(1)
      : isClass("learn", shown?.name ?? null)
        ? `learn/${shown?.name}`
        : "";
    return new PageState(place, shown?.Page ? shown.state : "", tellUnread);
  }, [figure, shown]);
  const before = useRef<Shown | null>(null);
  useEffect(printLight, []);
  useEffect(() => {
    document.addEventListener("copy", copySelection);
    return () => document.removeEventListener("copy", copySelection);
  }, []);
  const list = shown && !shown.Page ? shown.place : null;
  useKeptPlace(top, list);

  useEffect(() => {
    if (!shown) return;
    document.title = `${figure ? `${figure.number}: ${figure.title}` : TITLES[shown.place]} · Frond`;
    const step = shown.Page && openedStep(page);
    if (step) showStep(top.current, step);
    else if (before.current !== null && before.current !== shown) {
      // Another page is read from its top, a list from where it was left; and whoever listens hears its name.
      const at = shown.Page ? 0 : (left.get(shown.place) ?? 0);
      top.current?.closest("main")?.scrollTo({ top: at });
      top.current?.querySelector<HTMLElement>("h1")?.focus({ preventScroll: true });
    }
    before.current = shown;
  }, [shown, figure, page]);

  return (
    <div
      class={figuresCss["figures"]}
      ref={top}
      data-list={list ?? undefined}
      onPointerOver={fetchAhead}
      onFocusIn={fetchAhead}
    >
      {problem !== null && <Unloaded name={name} problem={problem} onTry={retry} />}
      {found && figure && shown?.Page ? (
        <article
          class={figuresCss["figure"]}
          aria-busy={shown.name !== name}
          onClickCapture={(event) => noteBefore(event, page)}
        >
          <TopNav {...found} />
          <PageOf.Provider value={page}>
            <shown.Page
              key={`${figure.id}/${shown.state}`}
              id={figure.id}
              number={figure.number}
              title={figure.title}
            />
          </PageOf.Provider>
          <Related figure={figure} />
          <NextNav {...found} />
        </article>
      ) : shown?.Page ? (
        <PageOf.Provider value={page}>
          <shown.Page key={`${shown.name}/${shown.state}`} id="" number="" title="" />
        </PageOf.Provider>
      ) : (
        shown &&
        (shown.place === "learn" ? <Contents missing={shown.name} /> : <Overview missing={shown.name} />)
      )}
    </div>
  );
}

/** Before a link is followed the address becomes that of the page as it is, so that the way back leads there. */
function noteBefore({ target }: Event, page: PageState): void {
  const link = target instanceof Element ? target.closest("a[href^='#']") : null;
  const fragment = page.fragment();
  if (link && fragment.length < MOST_NOTED) history.replaceState(history.state, "", fragment);
}

/** A longer address would not be read back. */
const MOST_NOTED = 3900;

function tellUnread(): void {
  notify({ kind: "info", text: "Part of this link could not be read: that part is as the page begins." });
}

/** What is asked for once it is fetched; what was shown before stays until then. */
function useShown(place: Place["page"], name: string | null, state: string) {
  const [shown, setShown] = useState<Shown | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const [tries, setTries] = useState(0);
  useEffect(() => {
    let asked = true;
    const figure = name === null ? undefined : find(name)?.figure;
    const page = figure ? pageOf(figure) : isClass(place, name) ? CLASS[name]?.() : null;
    Promise.resolve(page ?? null).then(
      (Page) => asked && setShown({ place, name, state, Page }),
      (reason) => {
        if (!asked) return;
        // Some browsers fetch a module that failed no second time: the page anew does, and the address keeps all.
        if (tries > 0 && navigator.onLine) location.reload();
        else setProblem(wordsOf(reason));
      },
    );
    return () => {
      asked = false;
      setProblem(null);
    };
  }, [place, name, state, tries]);
  return { shown, problem, retry: () => setTries(tries + 1) };
}

/** How far each list was scrolled when it was left. */
const left = new Map<Place["page"], number>();

/** Notes how far a list is scrolled, while one is shown. */
function useKeptPlace(inside: { current: HTMLElement | null }, list: Place["page"] | null): void {
  useEffect(() => {
    const main = inside.current?.closest("main");
    if (!main || list === null) return;
    // A shorter page in its place scrolls too, before this ends.
    const note = () => inside.current?.dataset["list"] === list && left.set(list, main.scrollTop);
    main.addEventListener("scroll", note, { passive: true });
    return () => main.removeEventListener("scroll", note);
  }, [inside, list]);
}

/** Whoever comes near a link will soon want its page. */
function fetchAhead({ target }: Event): void {
  const link = target instanceof Element ? target.closest("a[href^='#figures/'], a[href^='#learn/']") : null;
  const [, id = ""] = link?.getAttribute("href")?.split("/") ?? [];
  const figure = find(id)?.figure;
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

interface Found {
  row: Row;
  figure: Figure;
}

/** Every page of the same row by its number. */
function TopNav({ row, figure: here }: Found) {
  const lesson = lessonOf(here);
  const sheet = sheetBehind();
  const section = sectionWith(row, here);
  return (
    <nav class={figuresCss["figure-top"]} aria-label={row.name}>
      {sheet && <a href={sheet}>Back to the class sheet</a>}
      {lesson ? <a href="#learn">All lessons</a> : <a href="#figures">All figures</a>}
      <span class={figuresCss["unit"]}>
        {lesson ? row.title : row.paper}
        {section && `, section ${section.number}`}
      </span>
      <ol>
        {row.figures.map((figure) => (
          <li key={figure.id}>
            <a
              href={hrefOf(figure)}
              aria-label={figure.number}
              aria-current={figure === here ? "page" : undefined}
            >
              {figure.short}
            </a>
          </li>
        ))}
      </ol>
    </nav>
  );
}

/** From a lesson to the figures of the papers that show the same, and back. */
function Related({ figure }: { figure: Figure }) {
  const others = related(figure);
  if (others.length === 0) return null;
  return (
    <p class={figuresCss["related"]}>
      {lessonOf(figure) ? "The same in the papers: " : "A lesson on this: "}
      {others.map((other, i) => (
        <>
          {i > 0 && ", "}
          <a key={other.id} href={hrefOf(other)}>
            {other.number}, {other.title}
          </a>
        </>
      ))}
    </p>
  );
}

/** One back and one on, by name. */
function NextNav(found: Found) {
  const { before, next } = neighbours(found);
  const sheet = sheetBehind();
  return (
    <nav class={figuresCss["figure-next"]} aria-label="Before and after">
      {sheet && (
        <a class={figuresCss["figure-sheet"]} href={sheet}>
          Back to the class sheet
        </a>
      )}
      <Step figure={before} rel="prev" />
      <Step figure={next} rel="next" />
    </nav>
  );
}

function Step({ figure, rel }: { figure: Figure | undefined; rel: "prev" | "next" }) {
  return (
    figure && (
      <a class={rel === "next" ? figuresCss["on"] : undefined} href={hrefOf(figure)} rel={rel}>
        <span>{figure.number}</span>
        {figure.title}
      </a>
    )
  );
}
