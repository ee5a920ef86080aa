import type { ComponentChildren } from "preact";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { reducedMotion } from "#document/preferences";
import type { Point } from "../../kit/maps/pieces";
import { pictured, type Sheet, useDrawing } from "../../kit/picture/canvas";
import { between, partAt, triangleOf, trianglesIn, type View, viewOf } from "./view";
import css from "./zoom.module.css";

/** The sides of the smallest triangles, in device pixels. */
const FINE = 2;
const SECONDS = 0.45;
const UNITS = 400;

interface ZoomProps {
  /** The letters of the piece that is looked at, from 0; its three parts are in colour. */
  letters: readonly number[];
  label: string | null;
  /** What is drawn over it; its units are a 400th of the width. */
  children?: (place: (point: Point) => Point) => ComponentChildren;
  /** A part of the piece was pressed. */
  onPick?: (letter: number) => void;
}

/** The gasket, near a piece. Another piece is flown to. */
export function Zoom({ letters, label, children, onPick }: ZoomProps) {
  const target = useMemo(() => viewOf(triangleOf(letters)), [letters]);
  const view = useFlight(target);
  const draw = useMemo(() => (sheet: Sheet) => paint(sheet, view, letters), [view, letters]);
  const { canvas } = useDrawing(draw);
  const place = ([x, y]: Point): Point => [
    UNITS / 2 + ((x - view.x) / view.width) * UNITS,
    UNITS / 2 - ((y - view.y) / view.width) * UNITS,
  ];
  const press = (event: PointerEvent) => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    const at: Point = [
      target.x + ((event.clientX - box.left) / box.width - 0.5) * target.width,
      target.y - ((event.clientY - box.top) / box.height - 0.5) * target.width,
    ];
    const letter = partAt(letters, at);
    if (letter !== null) onPick?.(letter);
  };
  return (
    <div class={css["zoom"]}>
      <canvas ref={canvas} {...pictured(label)} />
      <svg
        viewBox={`0 0 ${UNITS} ${UNITS}`}
        class={onPick ? css["pressed"] : ""}
        aria-hidden="true"
        onPointerDown={onPick && press}
      >
        {children?.(place)}
      </svg>
    </div>
  );
}

/** The view on its way to where it shall be; there at once where motion is not wanted. */
function useFlight(target: View): View {
  const [view, setView] = useState(target);
  const latest = useRef(view);
  latest.current = view;
  useEffect(() => {
    const from = latest.current;
    if (reducedMotion.peek() || from === target) {
      setView(target);
      return;
    }
    let start: number | null = null;
    let frame = requestAnimationFrame(function fly(now) {
      start ??= now;
      const part = Math.min(1, (now - start) / 1000 / SECONDS);
      setView(between(from, target, part * part * (3 - 2 * part)));
      if (part < 1) frame = requestAnimationFrame(fly);
    });
    return () => cancelAnimationFrame(frame);
  }, [target]);
  return view;
}

function paint(
  { context, width, height, colours, token }: Sheet,
  view: View,
  letters: readonly number[],
): void {
  const scale = width / view.width;
  const faint = token("--line-strong");
  const depth = letters.length;
  for (const small of trianglesIn(view, FINE / scale, depth + 1)) {
    const isInside = letters.every((letter, i) => small.letters[i] === letter);
    context.fillStyle = isInside ? (colours[small.letters[depth] ?? 0] ?? faint) : faint;
    const [x, y] = [width / 2 + (small.x - view.x) * scale, height / 2 - (small.y - view.y) * scale];
    const side = small.side * scale;
    // So small that nobody sees whether it is a triangle.
    context.fillRect(x, y - side, Math.max(1, side), Math.max(1, side));
  }
}
