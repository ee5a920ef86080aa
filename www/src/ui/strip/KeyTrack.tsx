import "./key-track.css";
import type { ComponentChildren, ComponentType, JSX } from "preact";
import { useRef } from "preact/hooks";
import { endGesture } from "#document/scene";
import { keyStep } from "#format/numbers";

interface KeyTrackProps {
  label: string;
  /** In the order of their moments, from 0 to `length`. */
  keys: readonly { at: number }[];
  length: number;
  /** The key at the present moment, or -1. */
  here: number;
  /** The one that the tab key reaches. */
  reach: number;
  /** What one arrow key moves a key by. */
  step: number;
  /** The name of a key, and what else is said of it. */
  about: (index: number) => Partial<JSX.IntrinsicElements["button"]>;
  /** Goes to its moment; what plays stops. */
  go: (index: number) => void;
  /** Moves it in time, as a part of the gesture. */
  move: (index: number, to: number) => void;
  remove: (index: number) => void;
  /** Adds one, where the track is pressed twice. */
  add?: (at: number) => void;
  /** What is seen at a key, small. */
  Picture: ComponentType<{ index: number }>;
  children?: ComponentChildren;
}

/** Less is a press, not a drag: in pixels. */
const PRESS = 4;

/** Keys as diamonds at their moments, each with its picture: press to go there, drag to move them in time. */
export function KeyTrack(props: KeyTrackProps) {
  const { keys, length, here, reach, step, about, go, move, remove, add, Picture } = props;
  const track = useRef<HTMLDivElement>(null);
  const drag = useRef<{ x: number; offset: number; moved: boolean } | null>(null);
  const timeOf = (clientX: number): number => {
    const box = track.current?.getBoundingClientRect();
    return box && box.width > 0 ? ((clientX - box.left) / box.width) * length : 0;
  };
  const focus = (to: number) => {
    const index = Math.min(keys.length - 1, Math.max(0, to));
    go(index);
    track.current?.querySelectorAll("button")[index]?.focus();
  };
  const end = () => {
    if (drag.current?.moved) endGesture();
    drag.current = null;
  };
  const onKey = (event: KeyboardEvent, index: number, at: number) => {
    if (event.ctrlKey || event.metaKey) return;
    const to = {
      "[": index - 1,
      PageDown: index - 1,
      "]": index + 1,
      PageUp: index + 1,
      Home: 0,
      End: keys.length - 1,
    }[event.key];
    const by = keyStep(event, step);
    if (to !== undefined) focus(to);
    else if (by !== null) move(index, at + by);
    else if (event.key === "Delete" || event.key === "Backspace" || event.key === "-") {
      remove(index);
      focus(index - 1);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is for forms
    <div
      class="key-track"
      ref={track}
      role="group"
      aria-label={props.label}
      style={{ "--count": String(keys.length) }}
      onDblClick={(event) => {
        if (event.target === event.currentTarget) add?.(Math.min(length, Math.max(0, timeOf(event.clientX))));
      }}
    >
      {keys.map(({ at }, index) => (
        <button
          // Keys keep their order, so their number is their name.
          key={index}
          type="button"
          class={`key-mark ${here === index ? "chosen" : ""}`}
          style={{ left: `${(100 * at) / length}%` }}
          tabIndex={reach === index ? 0 : -1}
          {...about(index)}
          onPointerDown={(event) => {
            if (event.button !== 0) return;
            event.currentTarget.setPointerCapture(event.pointerId);
            // What arrow keys did before is a step of its own.
            endGesture();
            drag.current = { x: event.clientX, offset: at - timeOf(event.clientX), moved: false };
            go(index);
          }}
          onPointerMove={(event) => {
            const now = drag.current;
            if (!now) return;
            now.moved ||= Math.abs(event.clientX - now.x) > PRESS;
            if (now.moved) move(index, timeOf(event.clientX) + now.offset);
          }}
          onPointerUp={end}
          onPointerCancel={end}
          onLostPointerCapture={end}
          onClick={() => go(index)}
          onBlur={endGesture}
          onKeyDown={(event) => onKey(event, index, at)}
        >
          <span class="key-diamond" aria-hidden="true" />
          <Picture index={index} />
        </button>
      ))}
      {props.children}
    </div>
  );
}
