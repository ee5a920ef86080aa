import { computed } from "@preact/signals";
import { useRef } from "preact/hooks";
import { changeDeformation, deformation, movesAt } from "#document/deform/bend";
import { keyNear } from "#document/deform/keys";
import { endGesture } from "#document/scene";
import { keyStep } from "#format/numbers";
import { withKey, withKeyAt } from "../changes";
import { pausePhase, scrubPhase } from "../clock";
import { MeshIcon } from "./MeshIcon";
import { removeKey } from "./TimeOptions";
import { percentWords } from "./words";

const keys = computed(() => deformation.value.keys);
/** The key at the present moment, or -1. */
const here = computed(() => keyNear(deformation.value, deformation.value.phase));

/** The key frames as diamonds on the time line, each with its mesh below: press to go there, drag to move it in time. */
export function KeyTrack() {
  const track = useRef<HTMLDivElement>(null);
  const all = keys.value;
  const reach = Math.max(0, here.value);

  const timeOf = (clientX: number): number => {
    const box = track.current?.getBoundingClientRect();
    return box && box.width > 0 ? (clientX - box.left) / box.width : 0;
  };
  const focus = (index: number) => {
    const key = keys.peek()[index];
    if (!key) return;
    scrubPhase(key.at);
    track.current?.querySelectorAll<HTMLElement>("[role=slider]")[index]?.focus();
  };

  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is for forms
    <div
      class="keys"
      ref={track}
      role="group"
      aria-label="Key frames"
      style={{ "--count": String(all.length) }}
      onDblClick={(event) => {
        if (event.target !== event.currentTarget) return;
        pausePhase();
        const at = Math.min(1, Math.max(0, timeOf(event.clientX)));
        changeDeformation((d) => withKey(d, at, movesAt(d.keys, at, d.loop)));
      }}
    >
      {all.map((key, index) => (
        // Keys keep their order, so their number is their name.
        <Key key={index} index={index} at={key.at} tab={index === reach} timeOf={timeOf} focus={focus} />
      ))}
      {all.length === 1 && (
        <p class="keys-hint">One grid for all times. Choose a motion, or add key frames.</p>
      )}
    </div>
  );
}

interface KeyProps {
  index: number;
  at: number;
  tab: boolean;
  timeOf: (clientX: number) => number;
  focus: (index: number) => void;
}

/** Less is a press, not a drag. */
const SLACK = 4;

function Key({ index, at, tab, timeOf, focus }: KeyProps) {
  const drag = useRef<{ x: number; offset: number; moved: boolean } | null>(null);
  const count = keys.value.length;
  const chosen = here.value === index && count > 1;
  const move = (to: number) => changeDeformation((d) => withKeyAt(d, index, to), { gesture: `key ${index}` });
  const end = () => {
    if (drag.current?.moved) endGesture();
    drag.current = null;
  };
  return (
    <div
      class={`key-frame ${chosen ? "chosen" : ""}`}
      style={{ left: `${100 * at}%` }}
      role="slider"
      tabIndex={tab ? 0 : -1}
      aria-label={`Key frame ${index + 1} of ${count}`}
      aria-valuenow={Math.round(1000 * at) / 10}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuetext={percentWords(at)}
      title={`Key frame ${index + 1}, at ${percentWords(at)}`}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        drag.current = { x: event.clientX, offset: at - timeOf(event.clientX), moved: false };
        scrubPhase(at);
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
      onBlur={endGesture}
      onKeyDown={(event) => {
        if (event.ctrlKey || event.metaKey) return;
        const to = {
          "[": index - 1,
          PageDown: index - 1,
          "]": index + 1,
          PageUp: index + 1,
          Home: 0,
          End: count - 1,
        }[event.key];
        const by = keyStep(event, 0.01);
        if (to !== undefined) focus(to);
        else if (by !== null) {
          pausePhase();
          move(at + by);
        } else if (event.key === "Enter") scrubPhase(at);
        else if (event.key === "Delete" || event.key === "Backspace" || event.key === "-") {
          removeKey(index);
          focus(Math.max(0, index - 1));
        } else return;
        event.preventDefault();
        event.stopPropagation();
      }}
    >
      <span class="diamond" aria-hidden="true" />
      <MeshIcon index={index} />
    </div>
  );
}
