import { useMemo, useState } from "preact/hooks";
import { fixed } from "#format/numbers";
import { verdictPhrase } from "#format/verdict";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { Slider } from "#ui/controls/Slider";
import { PlayButton } from "#ui/strip/PlayButton";
import type { MapRow } from "#wasm/api";
import { frond } from "#wasm/core";
import { MARGIN, MOST_POINTS, SEED, startRun } from "../../kit/connectedness/buffer-run";
import { type Collisions, groups } from "../../kit/connectedness/collisions";
import { Buffer } from "../../kit/connectedness/index-buffer";
import { Graph } from "../../kit/connectedness/overlap-graph";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { Chip } from "../../kit/frame/verdict";
import { shrink } from "../../kit/maps/families";
import { number, oneOf, whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { usePlay } from "../../kit/time/play";
import timeCss from "../../kit/time/time.module.css";
import { useVerdict } from "../../kit/workers";
import css from "./page.module.css";
import { Theorem } from "./Theorem";

/** Steps a second while it plays. */
const PACE = 12;

const SHAPES = [
  { value: "gasket", label: "Gasket" },
  { value: "pentagon", label: "Pentagon" },
  { value: "terdragon", label: "Terdragon" },
  { value: "koch", label: "Koch" },
] as const;
const STEPS = [
  { value: "1", label: "1" },
  { value: "10", label: "10" },
  { value: "100", label: "100" },
] as const;

/** What stands in its address. */
export const STATE = {
  shape: kept<(typeof SHAPES)[number]["value"]>("gasket", oneOf(SHAPES.map(({ value }) => value))),
  pixels: kept(31, whole(8, 96)),
  scale: kept(1, number(0.8, 1, 3)),
  points: kept(300, whole(0, MOST_POINTS)),
  step: kept<(typeof STEPS)[number]["value"]>("10", oneOf(STEPS.map(({ value }) => value))),
};

/** The index buffer, point by point. */
export function Page(heading: Heading) {
  const [shape, setShape] = useKept("shape", ...STATE.shape);
  const [size, setSize] = useKept("pixels", ...STATE.pixels);
  const [scale, setScale] = useKept("scale", ...STATE.scale);
  const [count, setCount] = useKept("points", ...STATE.points);
  const [step, setStep] = useKept("step", ...STATE.step);

  const maps = useMemo(() => shrink(preset(shape).maps, scale), [shape, scale]);
  const run = useRun(maps, size, count);
  const angles = useMemo(() => directions(maps), [maps]);
  const truth = useVerdict(maps);
  const player = usePlayer(count, Number(step), setCount);
  const joined = groups(
    maps.length,
    run.edges.map((edge) => edge.between),
  );
  const whole = joined.count === 1;

  return (
    <Frame
      {...heading}
      lead={
        <p>
          A point hops about the shape by maps drawn at random, and each pixel remembers which piece plotted
          it last. When another piece falls into the same pixel, the two overlap as far as pixels tell, and
          the graph gains an edge. Once the graph hangs together, so does the picture. Large pixels say so too
          early: shrink the maps a little and see.
        </p>
      }
      found={
        <p>
          The buffer calls this {whole ? "connected" : `${joined.count} groups`} after {count} points. Frond’s
          search through pairs of pieces, which uses no pixels, says:{" "}
          <strong>{verdictPhrase(truth?.maps === maps ? truth.answer : null)}</strong>. Try the gasket at an
          even number of pixels a side: the points where its pieces touch then lie exactly on borders between
          pixels, and the buffer never sees it whole.
        </p>
      }
      parameters={[
        { name: "Maps", symbol: "N", value: String(maps.length) },
        { name: "Scale of each map about its fixed point", value: fixed(scale, 3) },
        { name: "Index buffer", value: `${size} × ${size} pixels` },
        { name: "Window", value: `square about the shape, ${100 * MARGIN}% larger` },
        { name: "Points plotted", symbol: "n", value: `${count} of at most ${MOST_POINTS}` },
        { name: "Collisions", value: String(run.collisions) },
        { name: "Chances of the maps", value: "all the same" },
        { name: "Seed", value: String(SEED) },
      ]}
      captions={["Figure 2: The Index Buffer algorithm for determining path connectedness."]}
      reconstructed="The algorithm is the paper’s (what it prints as p = w₂v(x) is the map from the window to the pixels). It prints no example: shapes, resolution and points are chosen here."
      studio={{ href: href(shape, scale) }}
    >
      <div class={layout["controls"]}>
        <Segmented label="Shape" options={SHAPES} value={shape} onChange={setShape} />
        <Choice label="Points a step" options={STEPS} value={step} onChange={setStep} />
        <div class={layout["buttons"]}>
          <Button onClick={() => player.go(count + Number(step))} disabled={count >= MOST_POINTS}>
            Plot {step} more
          </Button>
          <Button icon="reset" onClick={() => player.go(0)} disabled={count === 0}>
            Clear
          </Button>
        </div>
      </div>
      <div class={timeCss["figure-time"]}>
        <PlayButton playing={player.playing} onToggle={player.toggle} />
        <Slider
          label="Points plotted"
          min={0}
          max={MOST_POINTS}
          step={Number(step)}
          value={count}
          valueText={`${count} points`}
          onChange={(next) => player.go(Math.round(next))}
        />
        <output class="number">{count} points</output>
      </div>
      <div class={layout["two-columns"]}>
        <div class={layout["panel"]}>
          <Buffer
            run={run}
            count={count}
            label={`Index buffer of ${size} by ${size} pixels with ${count} points plotted; ${run.collisions} times a pixel was plotted by two pieces.`}
          />
        </div>
        <div class={layout["panel"]}>
          <Graph count={maps.length} angles={angles} edges={run.edges} />
          <div aria-live="polite">
            <Chip
              tone={whole ? "close" : "broken"}
              text={whole ? "Connected" : `${joined.count} groups`}
              aside={whole ? `as far as ${size} pixels tell` : "so far"}
            />
          </div>
          <ol class={css["edges"]}>
            {run.edges.map(({ between: [i, j], at }) => (
              <li key={`${i}-${j}`}>
                {i + 1} meets {j + 1} <span class="number">at point {at}</span>
              </li>
            ))}
          </ol>
        </div>
      </div>
      <Theorem count={maps.length} edges={run.edges.map(({ between }) => between)} />
      <div class={layout["controls"]}>
        <SliderControl
          label="Pixels a side"
          range={[8, 96]}
          whole
          value={size}
          valueText={`${size} pixels`}
          onChange={setSize}
        />
        <SliderControl
          label="Scale of the maps"
          range={[0.8, 1]}
          step={0.01}
          value={scale}
          text={fixed(scale, 3)}
          onChange={setScale}
        />
      </div>
    </Frame>
  );
}

/** The run at a count of points; it goes on where it can, and begins anew to go back. */
function useRun(maps: MapRow[], size: number, count: number): Collisions {
  const fresh = useMemo(() => ({ run: startRun(maps, size) }), [maps, size]);
  if (fresh.run.count > count) fresh.run = startRun(maps, size);
  fresh.run.plotTo(count);
  return fresh.run;
}

function usePlayer(count: number, step: number, setCount: (count: number) => void) {
  const [rest, setRest] = useState(0);
  const player = usePlay((seconds) => {
    const due = rest + seconds * PACE;
    const next = Math.min(MOST_POINTS, count + step * Math.floor(due));
    setRest(due % 1);
    if (next !== count) setCount(next);
    return next < MOST_POINTS;
  });
  const go = (next: number) => {
    player.stop();
    setCount(Math.min(MOST_POINTS, Math.max(0, next)));
  };
  const toggle = () => {
    if (!player.playing && count >= MOST_POINTS) setCount(0);
    player.toggle();
  };
  return { playing: player.playing, go, toggle };
}

/** In which direction from the middle each piece lies. */
function directions(maps: MapRow[]): number[] {
  const { min, max } = frond.bounds({ maps });
  const [x, y] = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
  return maps.map(([a, b, c, d, e, f]) => Math.atan2(c * x + d * y + f - y, a * x + b * y + e - x));
}

function href(shape: string, scale: number): string {
  const whole = preset(shape);
  const apart = { name: `${whole.name}, maps at 0.8`, maps: shrink(whole.maps, 0.8) };
  return studioHref({ a: whole, b: apart, t: (1 - scale) / 0.2 });
}
