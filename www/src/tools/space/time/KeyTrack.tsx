import { computed } from "@preact/signals";
import { useRef } from "preact/hooks";
import { endGesture } from "#document/scene";
import { changeTimeline } from "#document/space/edits";
import { moment, timeline } from "#document/space/space";
import { keyStep } from "#format/numbers";
import type { SpaceTimeline } from "#wasm/api";
import { keyAt, withKeyAt } from "./changes";
import { pauseSpace, scrubSpace } from "./clock";
import { KeyPicture } from "./KeyPicture";
import { attempt, removeKey } from "./keys";
import { easeWords, keyWords, secondsWords } from "./words";

/** The key at the present moment, or -1. */
export const keyHere = computed(() => (timeline.value ? keyAt(timeline.value, moment.value) : -1));
/** The one that the tab key reaches: that of the moment, or the last before it. */
const reach = computed(() => {
  const keys = timeline.value?.keys ?? [];
  return Math.max(
    0,
    keyHere.value >= 0 ? keyHere.value : keys.findLastIndex((key) => key.at <= moment.value),
  );
});

/** The keys as diamonds at their moments: press to go there, drag to move them in time. */
export function KeyTrack({ line }: { line: SpaceTimeline }) {
  const track = useRef<HTMLDivElement>(null);
  const timeOf = (clientX: number): number => {
    const box = track.current?.getBoundingClientRect();
    return box && box.width > 0 ? ((clientX - box.left) / box.width) * line.seconds : 0;
  };
  const focus = (index: number) => {
    const key = timeline.peek()?.keys[index];
    if (!key) return;
    scrubSpace(key.at);
    track.current?.querySelectorAll<HTMLElement>("button")[index]?.focus();
  };
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is for forms
    <div
      class="space-keys"
      ref={track}
      role="group"
      aria-label="Keys"
      style={{ "--count": String(line.keys.length) }}
    >
      {line.keys.map((_, index) => (
        // Keys keep their order, so their number is their name.
        <Key key={index} line={line} index={index} timeOf={timeOf} focus={focus} />
      ))}
    </div>
  );
}

interface KeyProps {
  line: SpaceTimeline;
  index: number;
  timeOf: (clientX: number) => number;
  focus: (index: number) => void;
}

/** Less is a press, not a drag. */
const SLACK = 4;
const STEP = 0.1;

function Key({ line, index, timeOf, focus }: KeyProps) {
  const drag = useRef<{ x: number; offset: number; moved: boolean } | null>(null);
  const key = line.keys[index];
  if (!key) return null;
  const { at } = key;
  const count = line.keys.length;
  const move = (to: number) => {
    attempt(() => changeTimeline((now) => withKeyAt(now, index, to), { gesture: `space key ${index}` }));
    scrubSpace(timeline.peek()?.keys[index]?.at ?? at);
  };
  const end = () => {
    if (drag.current?.moved) endGesture();
    drag.current = null;
  };
  const about = `${secondsWords(at)}: ${keyWords(key)}; then ${easeWords(key.ease)}`;
  return (
    <button
      type="button"
      class={`space-key ${keyHere.value === index ? "chosen" : ""}`}
      style={{ left: `${(100 * at) / line.seconds}%` }}
      tabIndex={reach.value === index ? 0 : -1}
      aria-label={`Key ${index + 1} of ${count}, at ${about}`}
      aria-current={keyHere.value === index ? "true" : undefined}
      title={`Key ${index + 1} at ${about}. Arrows move it, Delete removes it.`}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        // What arrow keys did before is a step of its own.
        endGesture();
        drag.current = { x: event.clientX, offset: at - timeOf(event.clientX), moved: false };
        scrubSpace(at);
      }}
      onPointerMove={(event) => {
        const now = drag.current;
        if (!now) return;
        now.moved ||= Math.abs(event.clientX - now.x) > SLACK;
        if (now.moved) move(timeOf(event.clientX) + now.offset);
      }}
      onPointerUp={end}
      onPointerCancel={end}
      onLostPointerCapture={end}
      onClick={() => scrubSpace(timeline.peek()?.keys[index]?.at ?? at)}
      onBlur={endGesture}
      onKeyDown={(event) => {
        if (event.ctrlKey || event.metaKey) return;
        const to = {
          ",": index - 1,
          PageDown: index - 1,
          ".": index + 1,
          PageUp: index + 1,
          Home: 0,
          End: count - 1,
        }[event.key];
        const by = keyStep(event, STEP);
        if (to !== undefined) focus(Math.min(count - 1, Math.max(0, to)));
        else if (by !== null) {
          pauseSpace();
          move(at + by);
        } else if (event.key === "Delete" || event.key === "Backspace") {
          removeKey(index);
          focus(Math.max(0, index - 1));
        } else return;
        event.preventDefault();
        event.stopPropagation();
      }}
    >
      <span class="space-diamond" aria-hidden="true" />
      <KeyPicture index={index} />
    </button>
  );
}
