import { computed } from "@preact/signals";
import { useRef } from "preact/hooks";
import { changeDeformation, deformation } from "#document/deform/bend";
import { endGesture } from "#document/scene";
import { formatNumber } from "#format/numbers";
import { NumberField } from "#ui/controls/NumberField";
import { SliderField } from "#ui/controls/SliderField";
import { SliderMark } from "#ui/controls/SliderMarks";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { MOST_ROUGHNESS, withCorners, withDetail, withLocality } from "../changes";
import deformCss from "../deform.module.css";
import { deepest, problem, rough } from "../facts";
import { roughnessWords } from "../words";
import { PlainButton } from "./PlainButton";
import { DetailField, LocalityField } from "./ScaleFields";

const kb = computed(() => deformation.value.kb);
const ke = computed(() => deformation.value.ke);
const delta = computed(() => deformation.value.delta);
const superposed = computed(() => deformation.value.superposed);

/** How the displacements are handed on to the small parts. */
export function BendPanel() {
  return (
    <section class="stack" aria-label="Bend">
      <div class="section-head">
        <h2>How the parts answer</h2>
        <PlainButton />
      </div>
      <Locality />
      <Roughness />
      <Detail />
      <ChoiceRow
        label="Scales"
        value={superposed.value ? "all" : "last"}
        options={[
          { value: "all", label: "All together", description: "The sum of all scales, kb to ke" },
          { value: "last", label: "Smallest only", description: "Only the last shuffle, down to ke" },
        ]}
        onChange={(next) => changeDeformation((d) => ({ ...d, superposed: next === "all" }))}
      />
      {problem.value !== null && (
        <p class={deformCss["bend-problem"]} role="alert">
          {problem.value} <span class="dim">What is shown is the last that worked.</span>
        </p>
      )}
    </section>
  );
}

function Locality() {
  return (
    <LocalityField
      label="Locality"
      value={kb.value}
      ke={ke.value}
      ends={["scattered: every part answers", "plain"]}
      onChange={(next) => changeDeformation((d) => withLocality(d, next), { gesture: "kb" })}
    />
  );
}

function Detail() {
  const wished = useRef<number | null>(null);
  return (
    <DetailField
      label="Detail"
      value={ke.value}
      deepest={deepest.value}
      ends={["the whole", "the smallest parts"]}
      onChange={(next) => {
        wished.current ??= kb.peek();
        const wish = wished.current;
        changeDeformation((d) => withDetail(d, next, wish), { gesture: "ke" });
      }}
      onDone={() => {
        wished.current = null;
      }}
    />
  );
}

/** Upper ones first, as they are seen: their places in the list of four. */
const CORNERS = [
  { index: 2, name: "Upper left" },
  { index: 3, name: "Upper right" },
  { index: 0, name: "Lower left" },
  { index: 1, name: "Lower right" },
] as const;

function Roughness() {
  const now = delta.value;
  return (
    <div class="stack">
      {Array.isArray(now) ? (
        <fieldset class={deformCss["corners"]}>
          <legend class="row-name">
            Roughness <span class="symbol">δ</span>
          </legend>
          {CORNERS.map(({ index, name }) => (
            <NumberField
              key={index}
              label={name}
              value={now[index]}
              min={0}
              max={MOST_ROUGHNESS}
              step={0.05}
              digits={3}
              onChange={(next) =>
                changeDeformation(
                  (d) =>
                    Array.isArray(d.delta)
                      ? { ...d, delta: d.delta.map((x, i) => (i === index ? next : x)) as typeof now }
                      : d,
                  { gesture: `delta ${index}` },
                )
              }
              onDone={endGesture}
            />
          ))}
        </fieldset>
      ) : (
        <SliderField
          label="Roughness"
          symbol="δ"
          value={now}
          max={MOST_ROUGHNESS}
          words={roughnessWords(now, rough.value)}
          ends={["smooth", "rough"]}
          onChange={(next) => changeDeformation((d) => ({ ...d, delta: next }), { gesture: "delta" })}
        >
          {rough.value < MOST_ROUGHNESS && (
            <SliderMark
              at={rough.value / MOST_ROUGHNESS}
              title={`From ${formatNumber(rough.value, 2)} on it is rough: each scale answers more than it is smaller`}
            />
          )}
        </SliderField>
      )}
      <Switch
        checked={Array.isArray(now)}
        description="Four numbers, blended over the shape"
        onChange={(apart) => changeDeformation((d) => withCorners(d, apart))}
      >
        Differs from corner to corner
      </Switch>
    </div>
  );
}
