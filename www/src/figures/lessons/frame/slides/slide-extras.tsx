import { useCallback, useEffect, useRef, useState } from "preact/hooks";
import { Button, IconButton } from "#ui/controls/Button";
import { Dialog } from "#ui/overlay/Dialog";
import css from "./slide-extras.module.css";
import { clockWords, MOST_MINUTES, secondsLeft } from "./timer";

/** How long a class has to think; it is counted down before it. */
export interface Timer {
  minutes: number;
  /** What is left, in milliseconds, when it was begun or paused last. */
  left: number;
  /** When it was begun, by the clock of the page; null while it stands. */
  since: number | null;
  open: boolean;
  setMinutes(minutes: number): void;
  /** Opens it; begins and pauses it where it is open. */
  toggle(): void;
  run(is: boolean): void;
  reset(): void;
  close(): void;
}

const MINUTE = 60_000;

export function useTimer(): Timer {
  const [minutes, setMinutes] = useState(3);
  const [left, setLeft] = useState(3 * MINUTE);
  const [since, setSince] = useState<number | null>(null);
  const [open, setOpen] = useState(false);
  const run = (is: boolean) => {
    const now = performance.now();
    if (!is && since !== null) setLeft(Math.max(0, left - (now - since)));
    setSince(is ? now : null);
  };
  const reset = () => {
    setSince(null);
    setLeft(minutes * MINUTE);
  };
  const latest = useRef(() => {});
  latest.current = () => {
    if (!open) setOpen(true);
    else run(since === null);
  };
  return {
    minutes,
    left,
    since,
    open,
    setMinutes(next) {
      setMinutes(next);
      setLeft(next * MINUTE);
      setSince(null);
    },
    toggle: useCallback(() => latest.current(), []),
    run,
    reset,
    close() {
      setOpen(false);
      reset();
    },
  };
}

/** The timer in the bar, and above the bar what it is set by. */
export function SlideTimer({ timer }: { timer: Timer }) {
  const { minutes, left, since, open } = timer;
  const [seconds, setSeconds] = useState(0);
  useEffect(() => {
    const look = () => setSeconds(secondsLeft(left, since, performance.now()));
    look();
    if (since === null) return;
    const each = setInterval(look, 200);
    return () => clearInterval(each);
  }, [left, since]);
  const over = open && seconds === 0;
  return (
    <>
      <Button
        pressed={open}
        description="Minutes to think, counted down (T)"
        onClick={() => (open ? timer.close() : timer.toggle())}
      >
        Timer
      </Button>
      {open && (
        <section class={css["timer"]} aria-label="Timer" data-over={over ? "" : undefined}>
          <output class={`${css["clock"]} number`} aria-label="Time left">
            {clockWords(seconds)}
          </output>
          <label class={css["minutes"]}>
            Minutes
            <input
              type="number"
              min={1}
              max={MOST_MINUTES}
              inputMode="numeric"
              value={minutes}
              onInput={({ currentTarget }) => {
                const next = Math.round(currentTarget.valueAsNumber);
                if (next >= 1 && next <= MOST_MINUTES) timer.setMinutes(next);
              }}
            />
          </label>
          <Button
            kind="primary"
            icon={since === null ? "play" : "pause"}
            disabled={over}
            onClick={() => timer.run(since === null)}
          >
            {since === null ? "Start" : "Pause"}
          </Button>
          <IconButton icon="reset" label="Begin again" onClick={timer.reset} />
          <IconButton icon="close" label="Close the timer" onClick={timer.close} />
          {/* Each second would be too much to hear. */}
          <p role="status" class={css["over"]}>
            {over ? "Time is up." : ""}
          </p>
        </section>
      )}
    </>
  );
}

/** Nothing is seen: a class looks at who speaks. */
export function Blank({ onEnd }: { onEnd: () => void }) {
  const button = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    const before = document.activeElement;
    button.current?.focus();
    return () => {
      if (before instanceof HTMLElement) before.focus({ preventScroll: true });
    };
  }, []);
  return (
    <button
      ref={button}
      type="button"
      class={css["blank"]}
      aria-label="The screen is blank. Show the slide again"
      onClick={onEnd}
    />
  );
}

const KEYS: readonly (readonly [keys: string, does: string])[] = [
  ["→, Page Down", "the next slide"],
  ["←, Page Up", "the slide before"],
  ["Home, End", "the first slide, the last"],
  ["B, .", "a black screen, and back"],
  ["T", "the timer: opens it, then starts and pauses it"],
  ["L", "a large dot that follows the mouse"],
  ["?", "this list"],
  ["Esc", "back to the page"],
];

/** What keys do on slides. */
export function SlideKeys({ onClose }: { onClose: () => void }) {
  return (
    <Dialog
      title="Keys of the slides"
      about="A remote control for slides works as well: most send Page Up, Page Down and a full stop."
      onClose={onClose}
      reading
    >
      <dl class={css["keys"]}>
        {KEYS.map(([keys, does]) => (
          <div key={keys}>
            <dt>{keys}</dt>
            <dd>{does}</dd>
          </div>
        ))}
      </dl>
      <p class="hint">
        Slides begin unanswered, whatever you have tried on the page. What you try on slides is gone when you
        leave them, and the page is as it was.
      </p>
    </Dialog>
  );
}
