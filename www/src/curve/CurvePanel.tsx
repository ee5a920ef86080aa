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
      <section class={endsCss["ends"]} aria-label="The two shapes">
        <Card end="a" choose={choose} />
        <SwapEnds
          onSwap={() => {
            edit(swapCurves);
            const now = scene.peek().curves;
            if (now) announce(`Swapped: from ${now.a.name} to ${now.b.name}.`);
          }}
        />
        <Card end="b" choose={choose} />
      </section>
      <Way />
      <Photographs />
      <Colours />
      <SaveButtons />
      <section class={curveCss["curve-back"]} aria-label="Systems">
        <Button
          icon="play"
          description="A morph from a fern to B, edge by edge and in one piece all the way"
          onClick={() => {
            const now = scene.peek().curves;
            if (now) void fernBecomes(now.b);
          }}
        >
          From a fern to B
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
      note={`closed curve with ${size}`}
      count={`${curve.knots.length} knots`}
      picture={<CurveThumb morph={curveMorph.value} s={end === "a" ? 0 : 1} />}
      onChoose={() => choose(end)}
    >
      <Menu
        label={`More for shape ${upper}`}
        items={[
          { label: "Choose another …", icon: "grid", onSelect: () => choose(end) },
          {
            label: `Use as ${other} too`,
            icon: "copy",
            onSelect: () => {
              edit((before) => curveAtBoth(before, end));
              announce(`${name} is now at both ends.`);
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
    ["Knots", String(a.knots), now ? String(now.knots) : "…", String(b.knots)],
    ["Copies", String(a.copies), now ? String(now.copies) : "…", String(b.copies)],
    ["Dimension", figure(a.dimension), now ? figure(now.dimension) : "…", figure(b.dimension)],
  ];
  return (
    <section class={`${curveCss["curve-way"]} stack`} aria-labelledby="curve-way">
      <header class="section-head">
        <h2 id="curve-way">Closed all the way</h2>
      </header>
      <p class="hint">
        {same
          ? "Both ends are the same curve: choose another for one of them to have a morph."
          : wayWords(worst.value)}{" "}
        Outlines morph with outlines only.
      </p>
      <table class={curveCss["curve-table"]}>
        <thead>
          <tr>
            <td />
            <th scope="col">A</th>
            <th scope="col">now</th>
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
          <h3 class={curveCss["curve-sub"]}>How rough it is on the way</h3>
          <Along />
        </>
      )}
      {now && now.crossings > 0 && <p class="hint">Just now it {crossingWords(now.crossings)}.</p>}
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
    <section class="stack" aria-label="Photographs">
      <Switch
        checked={photographsShown.value}
        onChange={(shown) => {
          photographsShown.value = shown;
        }}
      >
        Their photographs
      </Switch>
      <p class="hint">
        Each leaf is carried along by its outline, by mean value coordinates (Floater 2003; Hormann and
        Floater 2006), while one fades into the other. They are in this browser alone: pictures and films show
        them, links and other files show the curves.
      </p>
    </section>
  );
}

const COLOURINGS: readonly { value: Colouring; label: string; description: string }[] = [
  { value: "map", label: "Copies", description: "One colour for all copies of an arc" },
  { value: "address", label: "Edges", description: "From edge to edge another colour" },
  { value: "density", label: "Plain", description: "One colour" },
];
const colouring = computed(() => (scene.value.colouring === "grid" ? "density" : scene.value.colouring));
const COLOUR_WORDS: Partial<Record<Colouring, string>> = {
  map: "Edges of one colour are copies of one arc; the rest is straight.",
  address: "Each copy has another colour than the one before; the rest is straight.",
};

function Colours() {
  return (
    <section class="stack" aria-label="Colour">
      <ChoiceRow
        label="Colour by"
        value={colouring.value}
        options={COLOURINGS}
        onChange={(next) => edit((before) => ({ ...before, colouring: next }))}
      />
      {colouring.value !== "density" && <p class="hint">{COLOUR_WORDS[colouring.value]}</p>}
    </section>
  );
}
