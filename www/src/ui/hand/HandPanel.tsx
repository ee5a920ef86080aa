import type { ComponentChildren } from "preact";
import { announce, notify, wordsOf } from "#document/notice";
import { AT_REST, fromSlider, type Kind, nearlySame, stepOf, toSlider } from "#geometry/maps/hand";
import type { Row } from "#geometry/maps/row";
import { Button } from "../controls/Button";
import { Segmented } from "../controls/Segmented";
import { SliderField } from "../controls/SliderField";
import * as messages from "../messages";
import { ChoiceRow } from "../panel/ChoiceRow";
import type { Hand } from "./hold";

/** A field takes more than its slider reaches. */
const ANY = {};
/** Shapes may be as small as they like. */
const FINE = { to: (x: number) => x, from: (x: number) => Number(x.toPrecision(5)) };

const KINDS = [
  { value: "turn", label: messages.rotate },
  { value: "move", label: messages.move },
  { value: "scale", label: messages.scale },
  { value: "shear", label: messages.shear },
  { value: "matrix", label: messages.any },
] as const;

interface HandPanelProps<Map extends Row> {
  of: Hand<Map>;
  /** Where it goes back to: as it was made, or as it was taken in hand. */
  as: "made" | "taken";
  /** All numbers of what was done to it. */
  matrix: ComponentChildren;
}

/** A shape by numbers: every change is one of its parameters (Darwish & Abd-El-Wahab, eq 1). */
export function HandPanel<Map extends Row>({ of, as, matrix }: HandPanelProps<Map>) {
  const was = as === "made" ? messages.asMade : messages.asBefore;
  const { kind, moved, identity, letGo, place } = of;
  const now = kind.value;
  return (
    <section class="stack" aria-label={messages.transform}>
      <div class="section-head">
        <h2>{messages.transform}</h2>
        <Button
          kind="quiet"
          icon="reset"
          disabled={nearlySame(moved.value, identity)}
          description={messages.backTo(was)}
          onClick={() => {
            letGo();
            try {
              place(null);
              announce(messages.backToDone(was));
            } catch (problem) {
              notify({ kind: "error", text: wordsOf(problem) });
            }
          }}
        >
          {messages.reset}
        </Button>
      </div>
      <Segmented
        label={messages.transformation}
        value={now}
        options={KINDS}
        onChange={(next) => {
          letGo();
          kind.value = next;
        }}
      />
      {now === "matrix" ? matrix : <Sliders of={of} kind={now} />}
    </section>
  );
}

function Sliders<Map extends Row>({ of, kind: what }: { of: Hand<Map>; kind: Kind }) {
  const { axes, hold, reach, about, change, letGo } = of;
  const numbers = hold.value?.numbers ?? AT_REST[what];
  const n = (name: string) => numbers[name] ?? 0;
  const lengths = stepOf(reach.value);
  const pairs = axes.flatMap((one) => axes.filter((other) => other !== one).map((other) => `${one}${other}`));
  return (
    <>
      {what === "turn" &&
        (axes.length === 2 ? (["z"] as const) : axes).map((axis) => (
          <SliderField
            field={ANY}
            key={axis}
            label={axes.length === 2 ? messages.angle : messages.aboutAxis(axis)}
            value={n(axis)}
            min={-180}
            max={180}
            step={1}
            unit="°"
            digits={2}
            onChange={(next) => change(what, axis, next)}
          />
        ))}
      {what === "move" &&
        axes.map((axis) => (
          <SliderField
            field={ANY}
            scale={FINE}
            key={axis}
            label={messages.alongAxis(axis)}
            value={n(axis)}
            min={-reach.value}
            max={reach.value}
            step={lengths}
            digits={4}
            onChange={(next) => change(what, axis, next)}
          />
        ))}
      {what === "scale" &&
        (["all", ...axes] as const).map((axis) => (
          <SliderField
            field={{ step: 0.1 }}
            key={axis}
            label={axis === "all" ? messages.allAxes : messages.alongAxis(axis)}
            value={n(axis)}
            min={-4}
            max={4}
            step={0.05}
            unit="×"
            scale={{ to: toSlider, from: fromSlider }}
            onChange={(next) => change(what, axis, next)}
          />
        ))}
      {what === "shear" &&
        pairs.map((pair) => (
          <SliderField
            field={ANY}
            key={pair}
            label={messages.slidesWith(pair.charAt(0), pair.charAt(1))}
            value={n(pair)}
            min={-2}
            max={2}
            step={0.05}
            onChange={(next) => change(what, pair, next)}
          />
        ))}
      {what !== "move" && (
        <ChoiceRow
          label={messages.pivot}
          name={messages.fixedPoint}
          value={about.value}
          options={[
            { value: "middle", label: messages.centre },
            { value: "origin", label: messages.origin },
          ]}
          onChange={(next) => {
            letGo();
            about.value = next;
          }}
        />
      )}
    </>
  );
}
