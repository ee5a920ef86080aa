import { changeFit, fitDocument } from "#document/fit";
import { endGesture } from "#document/scene";
import { SliderField } from "#ui/controls/SliderField";
import { useOwnId } from "#ui/id";
import fitCss from "../fit.module.css";
import { cutting } from "../stage/layers";
import { prepared } from "../work/outline";
import { chooseOutline, source } from "../work/source";
import * as messages from "./messages";

/** The most corners of a small picture of an outline. */
const MOST_CORNERS = 200;

/**
 * An outline (x, y, x, y, .. with y up) as the path of a small picture, in the middle of a square of `side` with y
 * down. Empty where it has no extent.
 */
export function pathOf(points: Float64Array, side: number): string {
  const count = points.length / 2;
  const xs = points.filter((_, i) => i % 2 === 0);
  const ys = points.filter((_, i) => i % 2 === 1);
  const range = (list: Float64Array) =>
    list.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)] as const, [
      Number.POSITIVE_INFINITY,
      Number.NEGATIVE_INFINITY,
    ] as readonly [number, number]);
  const [[left, right], [bottom, top]] = [range(xs), range(ys)];
  const scale = side / Math.max(right - left, top - bottom);
  if (!(scale > 0 && Number.isFinite(scale))) return "";
  const [x0, y0] = [side / 2 - (scale * (left + right)) / 2, side / 2 + (scale * (bottom + top)) / 2];
  const stride = Math.ceil(count / MOST_CORNERS);
  const corners: string[] = [];
  for (let i = 0; i < count; i += stride)
    corners.push(`${(x0 + scale * (xs[i] ?? 0)).toFixed(1)} ${(y0 - scale * (ys[i] ?? 0)).toFixed(1)}`);
  return `M${corners.join("L")}Z`;
}

const MOST_LISTED = 40;

/** The outline itself: which one, and how much of it is noise. */
export function OutlinePanel() {
  if (cutting.value) return null;
  const { smoothing } = fitDocument.value;
  const crossings = prepared.value?.crossings;
  return (
    <section class="stack" aria-label={messages.outline4}>
      <div class="section-head">
        <h2>{messages.outline4}</h2>
      </div>
      <Choice />
      <SliderField
        digits={2}
        label={messages.smoothing}
        value={smoothing}
        min={0}
        max={1}
        step={0.05}
        words={smoothingWords(smoothing)}
        ends={["none", messages.forNoise]}
        onChange={(next) => changeFit((now) => ({ ...now, smoothing: next }), { gesture: "smoothing" })}
        onDone={endGesture}
      />
      {crossings !== undefined && crossings !== 0 && (
        <p class="notes">
          {crossings === null ? messages.thisOutlineVeryTangled : messages.crossesItself(crossings)}
        </p>
      )}
    </section>
  );
}

/** The outlines of a file, each with its picture. Native radios give the list its keys. */
function Choice() {
  const now = source.value;
  const group = useOwnId("outline");
  if (now.kind !== "outlines" || now.outlines.length < 2) return null;
  return (
    <div class={fitCss["outline-cards"]} role="radiogroup" aria-label={messages.outline5}>
      {now.outlines.slice(0, MOST_LISTED).map((outline, i) => (
        <label key={i} class={fitCss["outline-card"]} title={outline.name}>
          <input
            type="radio"
            class="unseen"
            name={group}
            checked={i === now.chosen}
            onChange={() => chooseOutline(i)}
          />
          <svg viewBox="-6 -6 112 112" aria-hidden="true">
            <path d={pathOf(outline.points, 100)} />
          </svg>
          <span>{`${i + 1}: ${outline.name}`}</span>
        </label>
      ))}
    </div>
  );
}

function smoothingWords(x: number): string {
  if (x === 0) return "none";
  return messages.overSize((2 * x * x).toFixed(2));
}
