import "./slides.css";
import { signal } from "@preact/signals";
import { useContext, useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { Button, IconButton } from "#ui/controls/Button";
import { listenForEscape } from "#ui/escape";
import { focusOf } from "#ui/focus";
import { whole } from "../../../kit/state/fields";
import { Page, useNoted } from "../../../kit/state/kept";
import { stepsIn, toTop } from "../../../kit/state/steps";
import { useValue } from "../../../kit/workers";
import { useBelow, useFit } from "./slide-fit";
import css from "./slides.module.css";

/** The slide that is shown, from 0; null while the lesson is a page. */
const slide = signal<number | null>(null);

/** How an address says which slide it opens, from 1. */
const SLIDE = whole(1, 99);

/** Where the system does not give the whole screen, the window is filled. */
const fillScreen = () => document.documentElement.requestFullscreen?.().catch(() => undefined);

/** Shows the lesson as slides. */
export function SlidesButton() {
  return (
    <IconButton
      icon="slides"
      kind="quiet"
      label="Show as slides"
      description="step by step, as large as the screen"
      onClick={() => {
        slide.value = 0;
        void fillScreen();
      }}
    />
  );
}

/** The bar below the slides; it is the last part of a lesson. */
export function Slides() {
  const page = useContext(Page);
  const at = useValue(slide);
  useEffect(() => {
    const opened = page.opened("slide", SLIDE);
    if (opened !== null) slide.value = opened - 1;
    return () => {
      slide.value = null;
    };
  }, [page]);
  useNoted("slide", at === null ? null : SLIDE.write(at + 1));
  return at === null ? null : <Shown at={at} />;
}

const leave = () => {
  slide.value = null;
  if (document.fullscreenElement) document.exitFullscreen().catch(() => undefined);
};

function Shown({ at: asked }: { at: number }) {
  const [names, setNames] = useState<readonly string[]>([]);
  const [dot, setDot] = useState(false);
  const [full, setFull] = useState(document.fullscreenElement !== null);
  const bar = useRef<HTMLDivElement>(null);
  const last = names.length - 1;
  // A link may say more slides than there are.
  const at = last < 0 ? asked : Math.min(asked, last);
  const go = (by: number) => {
    slide.value = goal(at, by);
  };

  // Each time anew: the slides of the lesson before may be put away after these have begun.
  useLayoutEffect(() => {
    document.documentElement.dataset["slides"] = "";
  });
  // The lesson is what it was; only one of its steps is seen.
  useEffect(() => {
    const before = document.activeElement;
    return () => {
      delete document.documentElement.dataset["slides"];
      const here = steps().find(({ dataset }) => dataset["now"] !== undefined);
      for (const step of steps()) delete step.dataset["now"];
      if (here) toTop(here);
      if (before instanceof HTMLElement) before.focus({ preventScroll: true });
    };
  }, []);
  useLayoutEffect(() => {
    const all = steps();
    setNames(all.map(nameOf));
    for (const [i, step] of all.entries()) {
      if (i === at) step.dataset["now"] = "";
      else delete step.dataset["now"];
    }
    const here = all[at];
    if (!here) return;
    here.tabIndex = -1;
    here.focus({ preventScroll: true });
    here.closest("main")?.scrollTo({ top: 0 });
  }, [at]);

  useFit(bar, at, names.length);
  const [isMore, onward] = useBelow(bar, at);

  useEffect(() => listenForEscape(leave), []);
  useEffect(() => {
    // The system takes Escape there, and says so.
    const onChange = () => {
      setFull(document.fullscreenElement !== null);
      if (document.fullscreenElement === null) leave();
    };
    document.addEventListener("fullscreenchange", onChange);
    return () => document.removeEventListener("fullscreenchange", onChange);
  }, []);
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
      const act = actOf(event);
      if (act === null) return;
      event.preventDefault();
      event.stopPropagation();
      if (act === "dot") setDot((now) => !now);
      else slide.value = goal(at, act);
    };
    // Before sliders, which have the Page keys, too.
    document.addEventListener("keydown", onKey, true);
    return () => document.removeEventListener("keydown", onKey, true);
  }, [at]);

  return (
    <div data-slides-bar="" ref={bar}>
      <div class={css["slides-bar"]} role="toolbar" aria-label="Slides">
        <Button icon="back" disabled={at === 0} onClick={() => go(-1)}>
          Back
        </Button>
        {/* That of the page is on its first slide. */}
        {at > 0 && <h1 class="unseen">{names[0]}</h1>}
        <Where at={at} names={names} full={full} />
        {/* Its room is kept: the buttons beside it stay where they are. */}
        <Button class={`${css["onward"]} ${isMore ? "" : css["away"]}`} icon="down" onClick={onward}>
          <span class={css["word"]}>More below</span>
        </Button>
        <Button
          class={css["pointer"]}
          pressed={dot}
          description="A large dot that follows the mouse (L)"
          onClick={() => setDot(!dot)}
        >
          Pointer
        </Button>
        <Button description="Back to the page (Esc)" onClick={leave}>
          Leave
        </Button>
        <Button kind="primary" disabled={at >= last} onClick={() => go(1)}>
          Next
        </Button>
      </div>
      {dot && <Dot />}
    </div>
  );
}

/** Which slide it is, and a link to it. What is said of the link stands there for a moment. */
function Where({ at, names, full }: { at: number; names: readonly string[]; full: boolean }) {
  const page = useContext(Page);
  const [said, setSaid] = useState<string | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: what was said was said of another slide
  useEffect(() => setSaid(null), [at]);
  const copy = async () => {
    const address = `${location.origin}${location.pathname}${page.fragment()}`;
    try {
      await navigator.clipboard.writeText(address);
      setSaid("Link copied. It opens this slide as it is now.");
    } catch {
      setSaid(address);
    }
  };
  return (
    <>
      <span class={css["where"]} aria-live="polite">
        <span class="number">
          {at + 1} of {names.length}
        </span>{" "}
        <span class={said === null ? css["name"] : css["said"]}>{said ?? names[at]}</span>
      </span>
      {page.place !== "" && (
        <Button
          icon="link"
          description="Copy a link that opens this slide as it is now"
          onClick={() => void copy()}
        >
          <span class={css["word"]}>Link</span>
        </Button>
      )}
      {!full && document.fullscreenEnabled && (
        <Button
          class={css["fill"]}
          icon="enlarge"
          description="As large as the screen"
          onClick={() => void fillScreen()}
        >
          <span class={css["word"]}>Fill</span>
        </Button>
      )}
    </>
  );
}

/** What a press asks for: so many slides on, or the dot. */
function actOf({ key, target }: KeyboardEvent): number | "dot" | null {
  const focus = focusOf(target);
  if (key === "PageDown") return 1;
  if (key === "PageUp") return -1;
  if (focus === "typing") return null;
  if (key === "l" || key === "L") return "dot";
  // What lives by the arrow keys keeps them.
  const taken =
    focus === "slider" || isMoved(target) || (target instanceof Element && target.matches("input"));
  if (taken) return null;
  return key === "ArrowRight" ? 1 : key === "ArrowLeft" ? -1 : null;
}

/** Handles and pictures that can be moved by keys take the focus, and are no part of the text. */
function isMoved(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    target.tabIndex >= 0 &&
    !target.matches("button, a, summary, [data-step]")
  );
}

function Dot() {
  const [place, setPlace] = useState<{ x: number; y: number } | null>(null);
  useEffect(() => {
    const move = ({ clientX: x, clientY: y }: PointerEvent) => setPlace({ x, y });
    addEventListener("pointermove", move);
    return () => removeEventListener("pointermove", move);
  }, []);
  return (
    place && <div class={css["dot"]} style={{ translate: `${place.x}px ${place.y}px` }} aria-hidden="true" />
  );
}

function steps(): HTMLElement[] {
  const article = document.querySelector("article");
  return article ? stepsIn(article) : [];
}

/** So many slides on, within the lesson as it stands: keys may be pressed before its slides are counted. */
const goal = (at: number, by: number) => Math.max(0, Math.min(steps().length - 1, at + by));

/** What a step is called: its own name, or that of its heading. */
function nameOf(step: HTMLElement): string {
  return step.getAttribute("aria-label") ?? step.querySelector("h1, h2, h3")?.textContent?.trim() ?? "";
}
