import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { norm } from "../../kit/maps/pieces";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import lessonCss from "../frame/lesson.module.css";
import { flagPath } from "../lesson-6/flag";
import { pushing } from "../lesson-14/orbit";
import css from "./leaning.module.css";

/** What the map takes of what is across and of what is up. */
const SCALE = 0.6;
const [LEAST, MOST] = [0, 2];
/** The half height of the letter, in units of the drawing. */
const SIZE = 60;

/** A letter before one step and after it: pushed far enough it is longer than it was. */
export function Leaning() {
  const [push, setPush] = useKept("push", 1, number(LEAST, MOST, 2));
  const map = pushing(SCALE, push);
  const longest = norm(map);
  const words =
    longest > 1
      ? `Some lengths become ${fixed(longest)} times as long.`
      : `No length becomes more than ${fixed(longest)} times as long.`;
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <svg
        class={css["leaning"]}
        viewBox="0 0 400 180"
        role="img"
        aria-label={`The letter F upright, and pushed to the side by ${fixed(push)} times its height. ${words}`}
      >
        <path class={css["ground"]} d="M0 90H400" />
        <path class={css["before"]} transform="translate(70 90)" d={flagPath([1, 0, 0, 1, 0, 0], SIZE)} />
        <path class={css["after"]} transform="translate(255 90)" d={flagPath(map, SIZE)} />
        <text class={css["name"]} x={70} y={172}>
          before
        </text>
        <text class={css["name"]} x={255} y={172}>
          after a step
        </text>
      </svg>
      <div class={lessonCss["ask"]}>
        <SliderControl
          label="push to the side"
          symbol="k"
          range={[LEAST, MOST]}
          step={0.05}
          value={push}
          onChange={(next) => setPush(Number(next.toFixed(2)))}
        />
        <p class="number" aria-live="polite">
          {words}
        </p>
      </div>
    </div>
  );
}
