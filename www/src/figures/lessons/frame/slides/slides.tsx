import "./slides.css";
import { useContext, useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { Button, IconButton } from "#ui/controls/Button";
import { listenForEscape } from "#ui/escape";
import { focusOf, latinKey } from "#ui/focus";
import { whole } from "../../../kit/state/fields";
import { afresh, Page, useNoted } from "../../../kit/state/kept";
import { stepsIn, toTop } from "../../../kit/state/steps";
import { useValue } from "../../../kit/workers";
import { ANSWERS, slide, slideOfStep, slidesOf, stepOfSlide } from "./on-slides";
import { Blank, SlideKeys, SlideTimer, useTimer } from "./slide-extras";
import { useBelow, useFit } from "./slide-fit";
import css from "./slides.module.css";

/** How an address says which step it opens, from 1. */
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
      description="step by step, as large as the screen; nothing is answered there yet"
      onClick={() => {
        afresh.value = { of: ANSWERS };
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
    if (opened !== null) slide.value = slideOfStep(opened);
    return () => {
      slide.value = null;
      afresh.value = null;
    };
  }, [page]);
  useNoted("slide", at === null ? null : SLIDE.write(stepOfSlide(at)));
  return at === null ? null : <Shown at={at} />;
}

const leave = () => {
  slide.value = null;
  afresh.value = null;
  if (document.fullscreenElement) document.exitFullscreen().catch(() => undefined);
};

function Shown({ at: asked }: { at: number }) {
  const [names, setNames] = useState<readonly string[]>([]);
  const [dot, setDot] = useState(false);
  const [full, setFull] = useState(document.fullscreenElement !== null);
  const [blank, setBlank] = useState(false);
  const [help, setHelp] = useState(false);
  const timer = useTimer();
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
      const all = slides().flat();
      const here = all.find(({ dataset }) => dataset["now"] !== undefined);
      for (const step of all) delete step.dataset["now"];
      if (here) toTop(here);
      if (before instanceof HTMLElement) before.focus({ preventScroll: true });
    };
  }, []);
  useLayoutEffect(() => {
    const all = slides();
    setNames(all.map(nameOf));
    for (const [i, steps] of all.entries()) {
      for (const step of steps) {
        if (i === at) step.dataset["now"] = "";
        else delete step.dataset["now"];
      }
    }
    const here = all[at]?.[0];
    if (!here) return;
    here.tabIndex = -1;
    here.focus({ preventScroll: true });
    here.closest("main")?.scrollTo({ top: 0 });
  }, [at]);

  useFit(bar, at, names.length);
  const [isMore, onward] = useBelow(bar, at);

  // In time for a key that follows at once.
  useLayoutEffect(() => listenForEscape(() => (blank ? setBlank(false) : leave())), [blank]);
  useEffect(() => {
    // The system takes Escape there, and says so.
    const onChange = () => {
      setFull(document.fullscreenElement !== null);
      if (document.fullscreenElement === null && !document.querySelector("dialog[open]")) leave();
    };
    document.addEventListener("fullscreenchange", onChange);
    return () => document.removeEventListener("fullscreenchange", onChange);
  }, []);
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
      if (document.querySelector("dialog[open]")) return;
      const act = actOf(event);
      if (act === null) return;
      event.preventDefault();
      event.stopPropagation();
      if (act === "dot") setDot((now) => !now);
      else if (act === "blank") setBlank((now) => !now);
      else if (act === "timer") timer.toggle();
      else if (act === "help") setHelp(true);
      else {
        setBlank(false);
        slide.value = goal(at, act);
      }
    };
    // Before sliders, which have the Page keys, too.
    document.addEventListener("keydown", onKey, true);
    return () => document.removeEventListener("keydown", onKey, true);
  }, [at, timer.toggle]);

  return (
    <div data-slides-bar="" ref={bar}>
      <div class={css["slides-bar"]} role="toolbar" aria-label="Slides">
        <Button icon="back" disabled={at === 0} onClick={() => go(-1)}>
          <span class={css["word"]}>Back</span>
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
        <SlideTimer timer={timer} />
        <Button
          class={css["blank-button"]}
          description="A black screen, until a key is pressed (B or .)"
          onClick={() => setBlank(true)}
        >
          Blank
        </Button>
        <IconButton
          class={css["keys-button"]}
          icon="keyboard"
          label="Keys of the slides"
          popup="dialog"
          onClick={() => setHelp(true)}
        />
        <Button description="Back to the page (Esc)" onClick={leave}>
          Leave
        </Button>
        <Button kind="primary" disabled={at >= last} onClick={() => go(1)}>
          Next
        </Button>
      </div>
      {dot && <Dot />}
      {help && <SlideKeys onClose={() => setHelp(false)} />}
      {blank && <Blank onEnd={() => setBlank(false)} />}
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
          <span class={css["icon-word"]}>Link</span>
        </Button>
      )}
      {!full && document.fullscreenEnabled && (
        <Button
          class={css["fill"]}
          icon="enlarge"
          description="As large as the screen"
          onClick={() => void fillScreen()}
        >
          <span class={css["icon-word"]}>Fill</span>
        </Button>
      )}
    </>
  );
}

/** What a press asks for: so many slides on, or what lies over them. */
function actOf(event: KeyboardEvent): number | "dot" | "blank" | "timer" | "help" | null {
  const { target } = event;
  const focus = focusOf(target);
  const key = latinKey(event);
  if (key === "PageDown") return 1;
  if (key === "PageUp") return -1;
  if (focus === "typing" || focus === "field") return null;
  if (key === "l" || key === "L") return "dot";
  if (key === "b" || key === "B" || key === ".") return "blank";
  if (key === "t" || key === "T") return "timer";
  if (key === "?") return "help";
  // What lives by the arrow keys keeps them.
  const taken =
    focus === "slider" || isMoved(target) || (target instanceof Element && target.matches("input"));
  if (taken) return null;
  if (key === "Home") return -Infinity;
  if (key === "End") return Infinity;
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

function slides(): HTMLElement[][] {
  const article = document.querySelector("article");
  return article ? slidesOf(stepsIn(article)) : [];
}

/** So many slides on, within the lesson as it stands: keys may be pressed before its slides are counted. */
const goal = (at: number, by: number) => Math.max(0, Math.min(slides().length - 1, at + by));

/** What a slide is called by its first step: its own name, or that of its heading. */
function nameOf([step]: HTMLElement[]): string {
  if (!step) return "";
  return step.getAttribute("aria-label") ?? step.querySelector("h1, h2, h3")?.textContent?.trim() ?? "";
}
