import { useEffect, useRef, useState } from "preact/hooks";
import { route } from "#document/link";
import { playing } from "#document/playback";
import { scene } from "#document/scene";
import { tool } from "#document/tool";
import { evidenceOpen } from "#stage/evidence/shown";
import { Button } from "#ui/controls/Button";
import { Icon } from "#ui/controls/Icon";
import css from "./guide.module.css";
import * as messages from "./messages";
import { at, goTo, greeted, greeting, leave } from "./state";
import { type Doing, STEPS } from "./steps";

/** The round. */
export function Guide() {
  useEffect(
    () =>
      // Whoever goes elsewhere has had it.
      route.subscribe(({ page }) => {
        if (page === "studio") return;
        if (greeting.peek()) greeted();
        if (at.peek() !== null) leave(at.peek() ?? 0);
      }),
    [],
  );
  useEffect(() => {
    // So has whoever opens another tool: what is said is about this one.
    const first = tool.peek();
    return tool.subscribe((now) => {
      if (now !== first && greeting.peek()) greeted();
    });
  }, []);
  if (route.value.page !== "studio") return null;
  return at.value !== null && tool.value === "morph" ? <Round key={at.value} number={at.value} /> : null;
}

const now = (): Doing => ({ scene: scene.value, playing: playing.value, evidence: evidenceOpen.value });

function Round({ number }: { number: number }) {
  const step = STEPS[number];
  const [before] = useState<Doing>(() => ({
    scene: scene.peek(),
    playing: playing.peek(),
    evidence: evidenceOpen.peek(),
  }));
  const was = useRef(false);
  const heading = useRef<HTMLHeadingElement>(null);
  const place = usePlace(step?.target);
  useEffect(() => heading.current?.focus({ preventScroll: true }), []);
  useEffect(() => {
    const close = (event: KeyboardEvent) => {
      if (event.key === "Escape" && !event.defaultPrevented) leave(number);
    };
    addEventListener("keydown", close);
    return () => removeEventListener("keydown", close);
  }, [number]);
  if (!step) return null;
  // Once done it stays so, whatever is tried after.
  was.current ||= step.done?.(now(), before) ?? false;
  const done = was.current;
  const last = number === STEPS.length - 1;
  return (
    <>
      {place && <div class={css["ring"]} style={ringOf(place)} aria-hidden="true" />}
      <aside
        class={`${css["card"]} ${css["round"]}`}
        style={cardOf(place, evidenceOpen.value)}
        aria-labelledby="guide-title"
      >
        <p class={css["count"]}>{messages.stepOf(number + 1, STEPS.length)}</p>
        <h2 id="guide-title" ref={heading} tabIndex={-1}>
          {step.title}
        </h2>
        <p>{step.text}</p>
        <p class={css["done"]} aria-live="polite">
          {done && (
            <>
              <Icon name="check" size={16} /> {messages.done}
            </>
          )}
        </p>
        <div class={css["ways"]}>
          {number > 0 && <Button onClick={() => goTo(number - 1)}>{messages.back}</Button>}
          <Button
            kind={done || !step.done ? "primary" : "plain"}
            onClick={() => (last ? leave(number) : goTo(number + 1))}
          >
            {last ? messages.finish : messages.next}
          </Button>
          {last ? (
            <a class="button" href="#learn">
              {messages.goToLessons}
            </a>
          ) : (
            <Button class={css["skip"]} kind="quiet" onClick={() => leave(number)}>
              {messages.skip}
            </Button>
          )}
        </div>
      </aside>
    </>
  );
}

interface Rect {
  /** The left edge of what it lies in, which the card leaves free. */
  edge: number;
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Where a control is, followed as the page moves; null while it is not there. */
function usePlace(selector: string | undefined): Rect | null {
  const [place, setPlace] = useState<Rect | null>(null);
  useEffect(() => {
    if (!selector) return;
    // On a phone it comes under the picture, which the card then leaves free.
    document.querySelector(selector)?.scrollIntoView({ block: isNarrow() ? "start" : "center" });
    let frame = requestAnimationFrame(function look() {
      const target = document.querySelector(selector);
      const box = target?.getBoundingClientRect();
      const edge = target?.closest(".side")?.getBoundingClientRect().left ?? box?.left ?? 0;
      const next = box && box.width > 0 ? rounded({ ...box.toJSON(), edge }) : null;
      setPlace((before) => (same(before, next) ? before : next));
      frame = requestAnimationFrame(look);
    });
    return () => cancelAnimationFrame(frame);
  }, [selector]);
  return place;
}

const rounded = ({ edge, left, top, width, height }: Rect): Rect => ({
  edge: Math.round(edge),
  left: Math.round(left),
  top: Math.round(top),
  width: Math.round(width),
  height: Math.round(height),
});

const same = (p: Rect | null, q: Rect | null) =>
  p === q || (p?.left === q?.left && p?.top === q?.top && p?.width === q?.width && p?.height === q?.height);

const AROUND = 4;

const ringOf = ({ left, top, width, height }: Rect) => ({
  left: `${left - AROUND}px`,
  top: `${top - AROUND}px`,
  width: `${width + 2 * AROUND}px`,
  height: `${height + 2 * AROUND}px`,
});

/** As wide as the style says; beside the control where there is room. On narrow pages it lies at an edge. */
const CARD = { width: 320, height: 240, free: 16 };

const isNarrow = () => innerWidth < 760;

function cardOf(place: Rect | null, evidence: boolean) {
  if (isNarrow()) {
    // Over the header, and as little of the picture as can be, where it would hide the control, or what that opened.
    const hides = place !== null && place.top + place.height > innerHeight - CARD.height;
    return hides || evidence ? { top: "max(0.5rem, env(safe-area-inset-top))" } : { bottom: "1rem" };
  }
  if (!place) return {};
  const { width, height, free } = CARD;
  const toLeft = place.edge - width - free;
  const toRight = place.left + place.width + 2 * free;
  const left = toLeft >= free ? toLeft : toRight + width + free <= innerWidth ? toRight : free;
  const beside = toLeft >= free || toRight + width + free <= innerWidth;
  const top = beside ? place.top : place.top - height - 2 * free;
  return {
    left: `${left}px`,
    top: `${Math.max(64, Math.min(innerHeight - height - free, top))}px`,
  };
}
