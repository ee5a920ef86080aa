import { computed, signal } from "@preact/signals";
import { useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { spaceView } from "#document/space/space";
import { formatNumber } from "#format/numbers";
import { axisWords, divergingWords, unit } from "#format/placement";
import { ShadowPicture } from "#stage/ShadowPicture";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { SliderField } from "#ui/controls/SliderField";
import { Problem } from "#ui/panel/Problem";
import { FlattenedMaps } from "#ui/shapes/FlattenedMaps";
import type { EpsilonProjection, MapRow, MapRow3, Point3 } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "../messages";
import { object, rested } from "../now";
import shapeCss from "../shape.module.css";
import { different, takeShadow, tidy } from "./use";

const MAPS_SHOWN = 3;

interface EpsilonProps {
  maps: MapRow3[];
  direction: Point3;
  format: (value: number) => string;
}

const POWERS = {
  to: (value: number) => Math.log10(value),
  from: (at: number) => Number((10 ** at).toPrecision(2)),
};

/** The way of the paper: flattened by epsilon, what becomes of the parameters? */
function Epsilon({ maps, direction, format }: EpsilonProps) {
  const [epsilon, setEpsilon] = useState(0.1);
  const found = flattened(maps, direction, epsilon);
  return (
    <>
      <SliderField
        field={{ step: 0.01 }}
        label={messages.remainingThickness}
        symbol="ε"
        value={epsilon}
        min={-6}
        max={0}
        step={0.1}
        digits={6}
        scale={POWERS}
        onChange={(next) => {
          if (!(next > 0 && next <= 1)) return messages.enterNumberAbove0;
          setEpsilon(next);
          return undefined;
        }}
      />
      {"why" in found ? (
        <Problem words={found.why} />
      ) : (
        <>
          <p class="hint" role="status">
            {messages.largestNumber(format(found.largest), divergingWords(found.diverging))}
          </p>
          <FlattenedMaps of={found} most={MAPS_SHOWN} />
          <p class="hint">
            {found.maps.length > MAPS_SHOWN && `${messages.firstOfMaps(MAPS_SHOWN, found.maps.length)} `}
            {messages.shadowAxes}
          </p>
        </>
      )}
    </>
  );
}

function flattened(maps: MapRow3[], direction: Point3, epsilon: number): EpsilonProjection | { why: string } {
  try {
    return solid.epsilonProjection(maps, direction, epsilon);
  } catch (problem) {
    return { why: wordsOf(problem) };
  }
}

/** The direction of the light that throws the shadow. */
const direction = signal<Point3>([0, 0, 1]);

const AXES: readonly Point3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** Directions that every map keeps. */
const kept = computed((): Point3[] => {
  try {
    return rested.value.length > 0 ? solid.invariantDirections(rested.value) : [];
  } catch {
    return [];
  }
});

/** The system of the plane whose attractor is the shadow; else why there is none. */
const exact = computed(() => exactly(rested.value, direction.value));

function exactly(maps: MapRow3[], along: Point3): { maps: MapRow[] } | { why: string } {
  try {
    return { maps: solid.projectExactly(maps, along) };
  } catch (problem) {
    return { why: wordsOf(problem) };
  }
}

function towards(next: Point3): string | undefined {
  const along = unit(next);
  if (!along) return messages.directionNeedsLength;
  direction.value = along;
  return undefined;
}

const near = (p: Point3, q: Point3) => Math.abs(Math.abs(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]) - 1) < 1e-9;

/** The shadow on a plane: where it is a system of the plane by itself, and what becomes of one that is not. */
export function ProjectionPanel() {
  const now = direction.value;
  const others = kept.value.filter((one) => !AXES.some((axis) => near(axis, one))).slice(0, 6);
  return (
    <div class="stack">
      <p class="hint">{messages.lightAlong(axisWords(now))}</p>
      <fieldset class={shapeCss["solid-buttons"]} aria-label={messages.lightDirection}>
        {AXES.map((axis) => (
          <Button key={axisWords(axis)} pressed={near(axis, now)} onClick={() => towards(axis)}>
            {axisWords(axis)}
            {kept.value.some((one) => near(axis, one)) && <span class="dim"> {messages.kept}</span>}
          </Button>
        ))}
        {others.map((one) => (
          <Button key={axisWords(one)} pressed={near(one, now)} onClick={() => towards(one)}>
            {axisWords(one)}
            <span class="dim"> {messages.kept}</span>
          </Button>
        ))}
        <Button kind="quiet" onClick={fromEye}>
          {messages.asViewed}
        </Button>
      </fieldset>
      <div class={shapeCss["solid-three"]}>
        {(["x", "y", "z"] as const).map((axis, k) => (
          <NumberField
            key={axis}
            label={messages.directionOf(axis)}
            symbol={axis}
            terse
            value={now[k] ?? 0}
            step={0.05}
            onChange={(value) => towards(now.with(k, value) as Point3)}
          />
        ))}
      </div>
      <ShadowPicture maps={rested.value} direction={now} />
      <Exact />
    </div>
  );
}

function fromEye(): void {
  const view = spaceView.peek();
  if (!view) return;
  const { turn, tilt } = view;
  towards([-Math.sin(turn) * Math.cos(tilt), Math.cos(turn) * Math.cos(tilt), -Math.sin(tilt)]);
}

function Exact() {
  const found = exact.value;
  const name = object.value?.name ?? messages.shape2;
  if ("maps" in found) {
    const count = found.maps.length;
    const others = different(tidy(found.maps)).length;
    return (
      <>
        <p class="notes" role="status">
          <strong>{others < count ? messages.shadowIsOf(count, others) : messages.shadowIs(count)}</strong>
          <span>{messages.everyMapKeepsDirection}</span>
        </p>
        <div class={shapeCss["solid-buttons"]}>
          <Button icon="arrow" onClick={() => void takeShadow(name, found.maps, "morph")}>
            {messages.morph3}
          </Button>
          <Button icon="arrow" onClick={() => void takeShadow(name, found.maps, "deform")}>
            {messages.bend}
          </Button>
        </div>
      </>
    );
  }
  const few = kept.value.length === 0;
  return (
    <>
      <p class="notes" role="status">
        <strong>{messages.frondFindsNoIfs}</strong>
        <span>{found.why}</span>
        <span>
          {few
            ? messages.noDirectionKeptBy
            : messages.keptAre(kept.value.slice(0, 6).map(axisWords).join("; "))}
        </span>
      </p>
      <Epsilon maps={rested.value} direction={direction.value} format={(x) => formatNumber(x, 3)} />
    </>
  );
}
