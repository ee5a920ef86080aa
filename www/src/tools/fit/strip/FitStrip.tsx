import "#ui/strip/strip.css";
import { bytesOf, changeFit, fitDocument, withBytes } from "#document/fit";
import { endGesture } from "#document/scene";
import { HoldButton } from "#ui/controls/HoldButton";
import { NumberField } from "#ui/controls/NumberField";
import { Slider } from "#ui/controls/Slider";
import { narrow } from "#ui/media";
import { numbersPerMap } from "#workers/fit/map-numbers";
import fitCss from "../fit.module.css";
import * as messages from "../messages";
import {
  bytesAt,
  even,
  HIGH,
  HIGH_BYTES,
  LEAST_BYTES,
  LOW,
  LOW_BYTES,
  MOST_BYTES,
  numbersAt,
  placeOf,
} from "../numbers";
import { comparing } from "../stage/layers";
import { collageOptions, LEAST_NUMBERS, MOST_NUMBERS } from "../work/fitting";
import { Layers } from "./Layers";

/** The one slider: how many numbers; and what is looked at. */
export function FitStrip() {
  return (
    <section class={`strip ${fitCss["fit-strip"]}`} aria-label={messages.sizeFit}>
      <CompareButton />
      <Size />
      {!narrow.value && <Layers />}
    </section>
  );
}

function Size() {
  switch (fitDocument.value.model) {
    case "closed":
      return <Numbers />;
    case "spline":
      return <Bytes />;
    case "collage":
      return <Maps />;
  }
}

const BYTE_MARKS = [32, 50, 150, 500, 1500, 4000] as const;

function Bytes() {
  const bytes = bytesOf(fitDocument.value);
  const change = (next: number) =>
    changeFit((now) => (bytesOf(now) === next ? now : withBytes(now, next)), { gesture: "bytes" });
  return (
    <div class={fitCss["numbers"]}>
      <NumberField
        label={messages.bytesInFit}
        value={bytes}
        min={LEAST_BYTES}
        max={MOST_BYTES}
        whole
        onChange={(next) => change(Math.round(next))}
        onDone={endGesture}
      />
      <Slider
        label={messages.bytesInFit}
        value={placeOf(bytes)}
        min={LOW_BYTES}
        max={HIGH_BYTES}
        step={0.1}
        valueText={messages.bytesOf(bytes)}
        onChange={(place) => change(bytesAt(place))}
        onDone={endGesture}
      />
      <p class={`${fitCss["fit-scale"]} number`} aria-hidden="true">
        {BYTE_MARKS.map((n) => (
          <span key={n} style={{ left: `${(100 * (placeOf(n) - LOW_BYTES)) / (HIGH_BYTES - LOW_BYTES)}%` }}>
            {n}
          </span>
        ))}
      </p>
    </div>
  );
}

const MARKS = [12, 50, 260, 1000, 2000] as const;

function Numbers() {
  const { numbers } = fitDocument.value;
  const change = (next: number) =>
    changeFit((now) => (now.numbers === next ? now : { ...now, numbers: next }), { gesture: "numbers" });
  return (
    <div class={fitCss["numbers"]}>
      <NumberField
        label={messages.numbersInFit}
        value={numbers}
        min={LEAST_NUMBERS}
        max={MOST_NUMBERS}
        step={2}
        digits={0}
        onChange={(next) => change(even(next))}
        onDone={endGesture}
      />
      <Slider
        label={messages.numbersInFit}
        value={placeOf(numbers)}
        min={LOW}
        max={HIGH}
        step={0.1}
        valueText={messages.numbersIs(numbers)}
        onChange={(place) => change(numbersAt(place))}
        onDone={endGesture}
      />
      <p class={`${fitCss["fit-scale"]} number`} aria-hidden="true">
        {MARKS.map((n) => (
          <span key={n} style={{ left: `${(100 * (placeOf(n) - LOW)) / (HIGH - LOW)}%` }}>
            {n}
          </span>
        ))}
      </p>
    </div>
  );
}

const LEAST_MAPS = 2;
const MOST_MAPS = 200;

function Maps() {
  const { maps, separable } = collageOptions.value;
  const change = (next: number) => {
    const now = collageOptions.peek();
    const features = Math.max(now.features, 2 * next);
    collageOptions.value = { ...now, maps: next, features };
  };
  return (
    <div class={fitCss["numbers"]}>
      <NumberField
        label={messages.mapsInFit}
        value={maps}
        min={LEAST_MAPS}
        max={400}
        whole
        onChange={(next) => change(Math.round(next))}
      />
      <Slider
        label={messages.mapsInFit}
        value={Math.log2(Math.min(maps, MOST_MAPS))}
        min={Math.log2(LEAST_MAPS)}
        max={Math.log2(MOST_MAPS)}
        step={0.1}
        valueText={messages.mapsAndNumbers(maps, numbersPerMap(separable) * maps)}
        onChange={(place) => change(Math.round(2 ** place))}
      />
    </div>
  );
}

/** While it is held, the outline is seen without the fit. */
function CompareButton() {
  return (
    <HoldButton held={comparing} title={messages.holdToSeeOutline} command="compare">
      {messages.holdToCompare}
    </HoldButton>
  );
}
