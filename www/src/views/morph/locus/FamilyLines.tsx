import { homeOf } from "../../../engine/window";
import type { Uv } from "../../../state/path";
import { circlesOf, criticalScale, landmarksOf } from "./families";
import { isOutside } from "./Handles";
import { around, linePath } from "./marks";
import { piecesIn } from "./polyline";
import { shownWindow, sides, view } from "./view";
import { place } from "./way";
import { lowered } from "./words";

/** Pieces of an arc across a window: straight, to the eye. */
const PIECES = 96;

/** The part of a circle about 0 that comes near to a window, as points; null where none does. */
export function arcNear(
  radius: number,
  { u0, v0, u1, v1 }: { u0: number; v0: number; u1: number; v1: number },
): Uv[] | null {
  const [cx, cy] = [(u0 + u1) / 2, (v0 + v1) / 2];
  const reach = Math.hypot(u1 - u0, v1 - v0) / 2;
  const far = Math.hypot(cx, cy);
  if (Math.abs(far - radius) > reach) return null;
  const middle = Math.atan2(cy, cx);
  const half = reach >= radius / 2 ? Math.PI : Math.min(Math.PI, (1.2 * reach) / radius);
  return Array.from({ length: PIECES + 1 }, (_, k) => {
    const angle = middle + half * ((2 * k) / PIECES - 1);
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}

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
            <g key={kind} class={`circle ${kind}`}>
              <path class="halo" d={d} />
              <path d={d} />
            </g>
          );
        })}
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
            <g key={x} class="critical-tick">
              <path class="halo" d={d} />
              <path d={d} />
            </g>
          );
        })}
      </svg>
      {circlesOf(n).map(({ radius, name, kind }, i) => {
        const angle = ((45 - 16 * i) * Math.PI) / 180;
        return (
          <Note
            key={kind}
            at={[radius * Math.cos(angle), radius * Math.sin(angle)]}
            window={window}
            words={name}
          />
        );
      })}
      <Note at={[r, -1.6 * tick]} window={window} words={`r${lowered(n)}`} />
      {landmarksOf(n).map(({ name, s }) => {
        const [x, y] = place(s, window);
        if (isOutside([x, y])) return null;
        return (
          <span
            key={name}
            class="locus-mark landmark"
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
    <span class="locus-note" style={{ left: `${100 * x}%`, top: `${100 * y}%` }} aria-hidden="true">
      {words}
    </span>
  );
}
