import { computed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { curveAtBoth, type End, sameCurves, swapCurves } from "#document/curve/changes";
import { curveMorph, curves } from "#document/curve/curve";
import { photographs, photographsShown } from "#document/curve/photographs";
import { fernBecomes } from "#document/directed/outlines";
import { announce } from "#document/notice";
import { edit, scene } from "#document/scene";
import { BackToSystems } from "#stage/curve/BackToSystems";
import { CurveThumb } from "#stage/curve/CurveThumb";
import { Button } from "#ui/controls/Button";
import { Switch } from "#ui/controls/Switch";
import { Menu } from "#ui/overlay/Menu";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { EndCard, SwapEnds } from "#ui/shapes/EndCard";
import endsCss from "#ui/shapes/ends.module.css";
import type { Colouring } from "#wasm/api";
import { rough } from "#wasm/curve";
import { Along } from "./Along";
import curveCss from "./curve.module.css";
import { factsAlong, factsNow, watchFacts } from "./facts";
import * as messages from "./messages";
import { SaveButtons } from "./SaveButtons";
import { crossingWords, matchWords, sizeWords, unlikeWords, wayWords } from "./words";

/** What is shown of curves in place of a morph's panel. */
interface CurvePanelProps {
  /** Opens the gallery for an end. */
  choose: (end: "a" | "b") => void;
}

/** The morph of two closed curves: its ends, what happens on the way, and what can be taken along. */
export function CurvePanel({ choose }: CurvePanelProps) {
  useEffect(watchFacts, []);
  return (
    <>
      <section class={endsCss["ends"]} aria-label={messages.twoShapes}>
        <Card end="a" choose={choose} />
        <SwapEnds
          onSwap={() => {
            edit(swapCurves);
            const now = scene.peek().curves;
            if (now) announce(messages.swapped(now.a.name, now.b.name));
          }}
        />
        <Card end="b" choose={choose} />
      </section>
      <Way />
      <Photographs />
      <Colours />
      <SaveButtons />
      <section class={curveCss["curve-back"]} aria-label={messages.systems}>
        <Button
          icon="play"
          description={messages.morphFromFernTo}
          onClick={() => {
            const now = scene.peek().curves;
            if (now) void fernBecomes(now.b);
          }}
        >
          {messages.fromFernToB}
        </Button>
        <BackToSystems />
      </section>
    </>
  );
}

function Card({ end, choose }: { end: End } & CurvePanelProps) {
  const shape = curves.value?.[end];
  if (!shape) return null;
  const { name, curve } = shape;
  const [upper, other] = end === "a" ? ["A", "B"] : ["B", "A"];
  const size = sizeWords(curve);
  return (
    <EndCard
      end={end}
      name={name}
      note={messages.closedWith(size)}
      count={messages.knots(curve.knots.length)}
      picture={<CurveThumb morph={curveMorph.value} s={end === "a" ? 0 : 1} />}
      onChoose={() => choose(end)}
    >
      <Menu
        label={messages.moreFor(upper)}
        items={[
          { label: messages.chooseAnother, icon: "grid", onSelect: () => choose(end) },
          {
            label: messages.alsoAs(other),
            icon: "copy",
            onSelect: () => {
              edit((before) => curveAtBoth(before, end));
              announce(messages.bothShapes(name));
            },
          },
        ]}
      />
    </EndCard>
  );
}

const ends = computed(() => {
  const now = curves.value;
  if (!now) return null;
  try {
    return { a: rough.curveFacts(now.a.curve), b: rough.curveFacts(now.b.curve), same: sameCurves(now) };
  } catch {
    return null;
  }
});

/** What becomes of the numbers on the way. */
function Way() {
  const both = ends.value;
  const now = factsNow.value;
  if (!both) return null;
  const { a, b, same } = both;
  const rows: [string, string, string, string][] = [
    [messages.knots2, String(a.knots), now ? String(now.knots) : "…", String(b.knots)],
    [messages.copies, String(a.copies), now ? String(now.copies) : "…", String(b.copies)],
    [messages.dimension, figure(a.dimension), now ? figure(now.dimension) : "…", figure(b.dimension)],
  ];
  return (
    <section class={`${curveCss["curve-way"]} stack`} aria-labelledby="curve-way">
      <header class="section-head">
        <h2 id="curve-way">{messages.closedAlongWholePath}</h2>
      </header>
      <p class="hint">{messages.outlinesOnly(same ? messages.bothEndsSameCurve : wayWords(worst.value))}</p>
      <table class={curveCss["curve-table"]}>
        <thead>
          <tr>
            <td />
            <th scope="col">A</th>
            <th scope="col">{messages.now}</th>
            <th scope="col">B</th>
          </tr>
        </thead>
        <tbody>
          {rows.map(([name, ...cells]) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              {cells.map((cell, i) => (
                <td key={i} class="number">
                  {cell}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
      {!same && now && <p class="hint">{matchWords(a.knots, b.knots, now.knots)}</p>}
      {!same && now && <Unlike a={a.knots} b={b.knots} both={now.knots} />}
      {!same && (
        <>
          <h3 class={curveCss["curve-sub"]}>{messages.roughnessAlongPath}</h3>
          <Along />
        </>
      )}
      {now && now.crossings > 0 && <p class="hint">{messages.nowCrosses(crossingWords(now.crossings))}</p>}
    </section>
  );
}

/** How often it crosses itself where it does so most, as far as the way was looked at. */
const worst = computed(() => Math.max(0, ...factsAlong.value.map(({ crossings }) => crossings)));

function Unlike({ a, b, both }: { a: number; b: number; both: number }) {
  const words = unlikeWords(a, b, both, worst.value);
  return words === null ? null : <p class="notes">{words}</p>;
}

function figure(dimension: number): string {
  return Number.isFinite(dimension) ? dimension.toFixed(2) : "…";
}

/** Where both ends were fitted to photographs that are still there. */
function Photographs() {
  if (!photographs.value) return null;
  return (
    <section class="stack" aria-label={messages.photos}>
      <Switch
        checked={photographsShown.value}
        onChange={(shown) => {
          photographsShown.value = shown;
        }}
      >
        {messages.theirPhotos}
      </Switch>
      <p class="hint">{messages.eachPhotoFollowsOutline}</p>
    </section>
  );
}

const COLOURINGS: readonly { value: Colouring; label: string; description: string }[] = [
  { value: "map", label: messages.copies, description: messages.oneColourForAll },
  { value: "address", label: messages.edges, description: messages.coloursAlternateFromEdge },
  { value: "density", label: messages.plain, description: messages.oneColour },
];
const colouring = computed(() => (scene.value.colouring === "grid" ? "density" : scene.value.colouring));
const COLOUR_WORDS: Partial<Record<Colouring, string>> = {
  map: messages.edgesOneColourCopies,
  address: messages.eachCopyHasDifferent,
};

function Colours() {
  return (
    <section class="stack" aria-label={messages.colour}>
      <ChoiceRow
        label={messages.colourBy}
        value={colouring.value}
        options={COLOURINGS}
        onChange={(next) => edit((before) => ({ ...before, colouring: next }))}
      />
      {colouring.value !== "density" && <p class="hint">{COLOUR_WORDS[colouring.value]}</p>}
    </section>
  );
}
