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
import deformCss from "../deform.module.css";
import { MOST_ROUGHNESS, withCorners, withDetail, withLocality } from "../deform-edits";
import { roughnessWords } from "../deform-text";
import { deepest, problem, rough } from "../facts";
import * as messages from "../messages";
import { DetailField, LocalityField, PlainButton } from "./fields";

const kb = computed(() => deformation.value.kb);
const ke = computed(() => deformation.value.ke);
const delta = computed(() => deformation.value.delta);
const superposed = computed(() => deformation.value.superposed);

/** How the displacements are handed on to the small parts. */
export function BendPanel() {
  return (
    <section class="stack" aria-label={messages.deformation2}>
      <div class="section-head">
        <h2>{messages.howPartsRespond}</h2>
        <PlainButton />
      </div>
      <Locality />
      <Roughness />
      <Detail />
      <ChoiceRow
        label={messages.scales}
        value={superposed.value ? "all" : "last"}
        options={[
          { value: "all", label: messages.allTogether, description: messages.sumAllScalesKb },
          { value: "last", label: messages.smallestOnly, description: messages.onlyLastShuffleDown },
        ]}
        onChange={(next) => changeDeformation((d) => ({ ...d, superposed: next === "all" }))}
      />
      {problem.value !== null && (
        <p class={deformCss["bend-problem"]} role="alert">
          {problem.value} <span class="dim">{messages.thisShowsLastSettings}</span>
        </p>
      )}
    </section>
  );
}

function Locality() {
  return (
    <LocalityField
      label={messages.locality}
      value={kb.value}
      ke={ke.value}
      ends={[messages.scatteredEveryPartResponds, "plain"]}
      onChange={(next) => changeDeformation((d) => withLocality(d, next), { gesture: "kb" })}
    />
  );
}

function Detail() {
  const wished = useRef<number | null>(null);
  return (
    <DetailField
      label={messages.detail}
      value={ke.value}
      deepest={deepest.value}
      ends={[messages.fullShape, messages.smallestParts]}
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
  { index: 2, name: messages.upperLeft },
  { index: 3, name: messages.upperRight },
  { index: 0, name: messages.lowerLeft },
  { index: 1, name: messages.lowerRight },
] as const;

function Roughness() {
  const now = delta.value;
  return (
    <div class="stack">
      {Array.isArray(now) ? (
        <fieldset class={deformCss["corners"]}>
          <legend class="row-name">
            {messages.roughness} <span class="symbol">δ</span>
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
          label={messages.roughness}
          symbol={messages.text}
          value={now}
          max={MOST_ROUGHNESS}
          words={roughnessWords(now, rough.value)}
          ends={["smooth", "rough"]}
          onChange={(next) => changeDeformation((d) => ({ ...d, delta: next }), { gesture: "delta" })}
        >
          {rough.value < MOST_ROUGHNESS && (
            <SliderMark
              at={rough.value / MOST_ROUGHNESS}
              title={messages.roughFrom(formatNumber(rough.value, 2))}
            />
          )}
        </SliderField>
      )}
      <Switch
        checked={Array.isArray(now)}
        description={messages.fourNumbersBlendedAcross}
        onChange={(apart) => changeDeformation((d) => withCorners(d, apart))}
      >
        {messages.variesByCorner}
      </Switch>
    </div>
  );
}
