import { useEffect, useRef } from "preact/hooks";
import { forNew } from "../dialogs";
import { BLANK_COUNTS, type BlankCount, blankShape } from "./blank";
import * as messages from "./messages";
import css from "./new-shape.module.css";

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
