import { useRef } from "preact/hooks";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import { verdictPhrase } from "#format/verdict";
import type { MapRow, Verdict } from "#wasm/api";
import { isBrokenVerdict } from "../frame/verdict";
import { useVerdict } from "../workers";
import { Picture } from "./picture";
import css from "./stills.module.css";

export interface StripFrame {
  t: number;
  maps: MapRow[];
}

interface StripProps {
  label: string;
  frames: readonly StripFrame[];
  box: Box;
  t: number;
  onPick: (t: number) => void;
}

/** Stills of a morph at even times, as the paper prints them, each with its verdict: press one to go there. */
export function Strip({ label, frames, box, t, onPick }: StripProps) {
  const list = useRef<HTMLOListElement>(null);
  const nearest = frames.reduce(
    (best, frame, i) => (Math.abs(frame.t - t) < Math.abs((frames[best]?.t ?? 0) - t) ? i : best),
    0,
  );
  const walk = (event: KeyboardEvent) => {
    const to = { ArrowRight: nearest + 1, ArrowLeft: nearest - 1, Home: 0, End: frames.length - 1 }[
      event.key
    ];
    const frame = to === undefined ? undefined : frames[to];
    if (to === undefined || frame === undefined) return;
    event.preventDefault();
    onPick(frame.t);
    list.current?.querySelectorAll<HTMLButtonElement>("button")[to]?.focus();
  };
  return (
    <ol
      class={css["stills"]}
      ref={list}
      aria-label={label}
      style={{ "--frames": String(frames.length) }}
      onKeyDown={walk}
    >
      {frames.map((frame, i) => (
        <Still key={frame.t} frame={frame} box={box} current={i === nearest} onPick={onPick} />
      ))}
    </ol>
  );
}

/** What is said of each, in as few words as there is room for. */
const MARKS: Record<Verdict, string> = {
  connected: "one piece",
  touching: "no gap seen",
  disconnected: "in pieces",
  undecided: "not decided",
  "no-attractor": "no attractor",
};

interface StillProps {
  frame: StripFrame;
  box: Box;
  current: boolean;
  onPick: (t: number) => void;
}

function Still({ frame, box, current, onPick }: StillProps) {
  const answer = useVerdict(frame.maps)?.answer ?? null;
  const broken = isBrokenVerdict(answer);
  return (
    <li>
      <button
        type="button"
        class={`${css["still"]} ${broken ? css["broken"] : ""}`}
        tabIndex={current ? 0 : -1}
        aria-current={current ? "true" : undefined}
        aria-label={`t = ${fixed(frame.t)}: ${verdictPhrase(answer)}`}
        title={`t = ${fixed(frame.t)}: ${verdictPhrase(answer)}`}
        onClick={() => onPick(frame.t)}
      >
        <Picture maps={frame.maps} box={box} label={null} margin={0.04} priority={40} />
        <span class={css["still-mark"]} aria-hidden="true">
          {answer === null ? "…" : MARKS[answer.verdict]}
        </span>
      </button>
    </li>
  );
}
