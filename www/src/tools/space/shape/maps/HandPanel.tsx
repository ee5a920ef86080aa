import { computed, signal } from "@preact/signals";
import { announce, notify, wordsOf } from "#document/notice";
import { endGesture } from "#document/scene";
import { placeObject } from "#document/space/edits";
import { chosen, IDENTITY } from "#document/space/space";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { SliderField } from "#ui/controls/SliderField";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import type { MapRow3, Point3 } from "#wasm/api";
import { solid } from "#wasm/space";
import { facts, factsOf, moved, parameters } from "../now";
import {
  AT_REST,
  fromSlider,
  type Kind,
  type Numbers,
  nearlySame,
  stepOf,
  toSlider,
  transformOf,
} from "./hand";
import { MatrixFields } from "./MatrixFields";

/** A field takes more than its slider reaches. */
const ANY = {};
/** Shapes may be as small as they like. */
const FINE = { to: (x: number) => x, from: (x: number) => Number(x.toPrecision(5)) };

/** What the sliders say, and from where: they are at rest as soon as something else has moved the object. */
interface Hold {
  index: number;
  kind: Kind;
  base: MapRow3;
  centre: Point3;
  radius: number;
  numbers: Numbers;
  /** Where that has put it. */
  put: MapRow3;
}

const held = signal<Hold | null>(null);
const kind = signal<Kind | "matrix">("turn");
const about = signal<"middle" | "origin">("middle");

const hold = computed(() => {
  const now = held.value;
  const goes = now && now.index === chosen.value && now.kind === kind.value;
  return goes && nearlySame(now.put, moved.value) ? now : null;
});

/** How far sliders of lengths reach. */
const reach = computed(() => {
  const radius = hold.value?.radius ?? facts.value?.radius ?? 1;
  return 3 * 10 ** Math.ceil(Math.log10(Math.max(radius, 1e-9)) - 0.3);
});

function change(what: Kind, name: string, value: number): string | undefined {
  const ball = hold.peek() ?? factsOf(parameters.peek()) ?? { centre: [0, 0, 0], radius: 1 };
  const { base, numbers } = hold.peek() ?? { base: moved.peek(), numbers: AT_REST[what] };
  const next = { ...numbers, [name]: value };
  const fixed: Point3 = about.peek() === "middle" ? (ball.centre as Point3) : [0, 0, 0];
  try {
    const put = solid.compose3(transformOf(what, next, fixed), base);
    placeObject(put, { gesture: `hand ${what} ${name}` });
    held.value = {
      index: chosen.peek(),
      kind: what,
      base,
      centre: ball.centre as Point3,
      radius: ball.radius,
      numbers: next,
      put,
    };
    return undefined;
  } catch (problem) {
    return wordsOf(problem);
  }
}

/** From here on: what the sliders have done stays, and they are at rest. */
function letGo(): void {
  endGesture();
  held.value = null;
}

const KINDS = [
  { value: "turn", label: "Turn" },
  { value: "move", label: "Move" },
  { value: "scale", label: "Scale" },
  { value: "shear", label: "Shear" },
  { value: "matrix", label: "Any" },
] as const;

/** The object by numbers: every change is one of its parameters. */
export function HandPanel() {
  const now = kind.value;
  return (
    <section class="stack" aria-label="Move its parameters">
      <div class="section-head">
        <h2>Move its parameters</h2>
        <Button
          kind="quiet"
          icon="reset"
          disabled={nearlySame(moved.value, IDENTITY)}
          description="Back to where it was made"
          onClick={() => {
            letGo();
            try {
              placeObject(null);
              announce("It is as it was made.");
            } catch (problem) {
              notify({ kind: "error", text: wordsOf(problem) });
            }
          }}
        >
          As made
        </Button>
      </div>
      <Segmented
        label="What is done to it"
        value={now}
        options={KINDS}
        onChange={(next) => {
          letGo();
          kind.value = next;
        }}
      />
      {now === "matrix" ? <MatrixFields key={chosen.value} /> : <Sliders kind={now} />}
    </section>
  );
}

const AXES = ["x", "y", "z"] as const;

function Sliders({ kind: what }: { kind: Kind }) {
  const numbers = hold.value?.numbers ?? AT_REST[what];
  const n = (name: string) => numbers[name] ?? 0;
  const lengths = stepOf(reach.value);
  return (
    <>
      {what === "turn" &&
        AXES.map((axis) => (
          <SliderField
            field={ANY}
            key={axis}
            label={`About ${axis}`}
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
        AXES.map((axis) => (
          <SliderField
            field={ANY}
            scale={FINE}
            key={axis}
            label={`Along ${axis}`}
            value={n(axis)}
            min={-reach.value}
            max={reach.value}
            step={lengths}
            digits={4}
            onChange={(next) => change(what, axis, next)}
          />
        ))}
      {what === "scale" &&
        (["all", ...AXES] as const).map((axis) => (
          <SliderField
            field={{ step: 0.1 }}
            key={axis}
            label={axis === "all" ? "All of it" : `Along ${axis}`}
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
        (["xy", "xz", "yx", "yz", "zx", "zy"] as const).map((pair) => (
          <SliderField
            field={ANY}
            key={pair}
            label={`${pair[0]} slides with ${pair[1]}`}
            value={n(pair)}
            min={-2}
            max={2}
            step={0.05}
            onChange={(next) => change(what, pair, next)}
          />
        ))}
      {what !== "move" && (
        <ChoiceRow
          label="What stays"
          name="What stays in its place"
          value={about.value}
          options={[
            { value: "middle", label: "its middle" },
            { value: "origin", label: "the origin" },
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
