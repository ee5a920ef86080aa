import { homeOf } from "#compute/locus/window";
import { lowered } from "#format/parameters";
import type { Uv } from "#geometry/path";
import { piecesIn } from "#geometry/polyline";
import fieldCss from "../field.module.css";
import { around, linePath } from "../marks";
import { isOutside } from "../path/handles";
import { place } from "../path/waypoints";
import { arcNear } from "../view/geometry";
import { shownWindow, sides, view } from "../view/view";
import { criticalScale } from "./critical";
import { circlesOf } from "./families";
import { landmarksOf } from "./landmarks";
import { curve } from "./orbit";

/** What is known by proof, drawn over what is computed. */
export function FamilyLines() {
  const n = sides.value;
  const window = shownWindow.value;
  const within = around();
  const r = criticalScale(n);
  const { zoom } = view.value;
  // Half the height of the tick on the real line, in s.
  const tick = (0.03 * (homeOf("polygon").u1 - homeOf("polygon").u0)) / zoom;
  return (
    <>
      <svg class="locus-path family" viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">
        {circlesOf(n).map(({ radius, kind }) => {
          const arc = arcNear(radius, within);
          if (!arc) return null;
          const d = linePath(piecesIn(arc, within));
          return (
            <g key={kind} class={kind}>
              <path class={fieldCss["halo"]} d={d} />
              <path d={d} />
            </g>
          );
        })}
        <g class={fieldCss["course"]}>
          {[true, false].map((halo) => (
            <path
              key={`${halo}`}
              class={halo ? fieldCss["halo"] : ""}
              d={linePath(piecesIn(curve.value, within))}
            />
          ))}
        </g>
        {[r, -r].slice(0, n % 2 === 0 ? 2 : 1).map((x) => {
          const d = linePath(
            piecesIn(
              [
                [x, -tick],
                [x, tick],
              ],
              within,
            ),
          );
          return (
            <g key={x} class={fieldCss["critical-tick"]}>
              <path class={fieldCss["halo"]} d={d} />
              <path d={d} />
            </g>
          );
        })}
      </svg>
      {circlesOf(n).map(({ radius, name, kind }, i) => {
        const angle = ((225 + 16 * i) * Math.PI) / 180;
        return (
          <Note
            key={kind}
            at={[radius * Math.cos(angle), radius * Math.sin(angle)]}
            window={window}
            words={name}
          />
        );
      })}
      {n > 2 && <Note at={[r, -1.6 * tick]} window={window} words={`r${lowered(n)}`} />}
      {landmarksOf(n, criticalScale(n)).map(({ name, s }) => {
        const [x, y] = place(s, window);
        if (isOutside([x, y])) return null;
        return (
          <span
            key={name}
            class={`${fieldCss["locus-mark"]} landmark`}
            style={{ left: `${100 * x}%`, top: `${100 * y}%` }}
            aria-hidden="true"
          />
        );
      })}
    </>
  );
}

function Note({ at, window, words }: { at: Uv; window: ReturnType<typeof around>; words: string }) {
  const [x, y] = place(at, window);
  if (x < 0.04 || x > 0.96 || y < 0.03 || y > 0.97) return null;
  return (
    <span
      class={fieldCss["locus-note"]}
      style={{ left: `${100 * x}%`, top: `${100 * y}%` }}
      aria-hidden="true"
    >
      {words}
    </span>
  );
}
