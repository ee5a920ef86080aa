import { useEffect, useRef } from "preact/hooks";
import { UNIT } from "#geometry/boxes";
import type { MapRow, Shape } from "#wasm/api";
import { forNew } from "../dialogs";
import * as messages from "../messages";
import css from "./new-shape.module.css";

// A shape to begin with: so many copies of the unit square, each half as large.

/** Where the lower left corners of the copies are. Three stand as the gasket's do. */
const CORNERS: Record<1 | 2 | 3 | 4, readonly (readonly [number, number])[]> = {
  1: [[0, 0]],
  2: [
    [0, 0],
    [0.5, 0],
  ],
  3: [
    [0, 0],
    [0.5, 0],
    [0.25, 0.5],
  ],
  4: [
    [0, 0],
    [0.5, 0],
    [0, 0.5],
    [0.5, 0.5],
  ],
};

type BlankCount = keyof typeof CORNERS;
const BLANK_COUNTS: readonly BlankCount[] = [1, 2, 3, 4];

/** The frame that it is made in. */
export const BLANK_FRAME = UNIT;

export function blankShape(count: BlankCount): Shape {
  return { name: messages.newShape2, maps: CORNERS[count].map(([x, y]): MapRow => [0.5, 0, 0, 0.5, x, y]) };
}

/** Begins a shape with one to four copies of a square, which its maker then drags. */
export function NewShape({ onChoose }: { onChoose: (count: BlankCount) => void }) {
  const first = useRef<HTMLButtonElement>(null);
  const section = useRef<HTMLElement>(null);
  useEffect(() => {
    // Under a finger the list begins at its top, and not at the shape that is there now.
    if (matchMedia("(pointer: coarse)").matches)
      requestAnimationFrame(() => section.current?.scrollIntoView({ block: "end" }));
    if (!forNew.peek()) return;
    forNew.value = false;
    // After the dialog has gone to the shape that is there now.
    requestAnimationFrame(() => first.current?.focus());
  }, []);
  return (
    <section ref={section} class={css["new-shape"]} aria-labelledby="new-shape-title">
      <h3 id="new-shape-title">{messages.newShape2}</h3>
      <ul>
        {BLANK_COUNTS.map((count) => (
          <li key={count}>
            <button
              type="button"
              class={css["blank"]}
              ref={count === 1 ? first : null}
              onClick={() => onChoose(count)}
            >
              <Sign count={count} />
              <span>
                {count} {count === 1 ? "copy" : "copies"}
              </span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

/** The copies in their frame. */
function Sign({ count }: { count: BlankCount }) {
  return (
    <svg viewBox="-1 -1 26 26" width="26" height="26" aria-hidden="true">
      <rect class={css["blank-frame"]} width="24" height="24" />
      {blankShape(count).maps.map(([a, , , d, e, f]) => (
        <rect
          key={`${e} ${f}`}
          class={css["blank-copy"]}
          x={24 * e}
          y={24 * (1 - f - d)}
          width={24 * a}
          height={24 * d}
        />
      ))}
    </svg>
  );
}
