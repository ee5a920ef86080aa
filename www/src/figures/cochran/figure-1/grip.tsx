import { useRef } from "preact/hooks";
import { addStep, fixed, keyStep } from "#format/numbers";
import type { PlaceOf } from "../graphs/profile";
import css from "./grip.module.css";

interface GripProps {
  name: string;
  /** What its two numbers are called. */
  axes?: readonly [across: string, up: string];
  t: number;
  x: number;
  place: PlaceOf;
  size: { width: number; height: number };
  /** What a pixel is worth: from pixels of the plot to (t, x). */
  valueAt: (left: number, top: number) => [t: number, x: number];
  onMove: (t: number, x: number) => void;
}

const STEP = 0.02;

/** A point of a graph that mouse, finger and arrow keys move. */
export function Grip({ name, axes: [across, up] = ["t", "x"], t, x, place, valueAt, onMove }: GripProps) {
  const host = useRef<HTMLButtonElement>(null);
  const offset = useRef<[number, number]>([0, 0]);
  const [left, top] = place(t, x);
  const within = (event: PointerEvent): [number, number] => {
    const box = host.current?.parentElement?.getBoundingClientRect();
    return [event.clientX - (box?.left ?? 0), event.clientY - (box?.top ?? 0)];
  };
  return (
    <button
      ref={host}
      type="button"
      class={css["grip-point"]}
      style={{ left: `${left}px`, top: `${top}px` }}
      aria-label={`${name} at ${across} = ${fixed(t)}, ${up} = ${fixed(x)}: arrow keys move it, with Shift finer`}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        const [px, py] = within(event);
        offset.current = [left - px, top - py];
      }}
      onPointerMove={(event) => {
        if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
        const [px, py] = within(event);
        onMove(...valueAt(px + offset.current[0], py + offset.current[1]));
      }}
      onKeyDown={(event) => {
        if (event.ctrlKey || event.metaKey) return;
        const by = keyStep(event, STEP);
        if (by === null) return;
        event.preventDefault();
        const sideways = event.key === "ArrowLeft" || event.key === "ArrowRight";
        if (sideways) onMove(addStep(t, by), x);
        else onMove(t, addStep(x, by));
      }}
    />
  );
}
