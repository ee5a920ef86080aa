import { useMemo } from "preact/hooks";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import { Segmented } from "#ui/controls/Segmented";
import { Switch } from "#ui/controls/Switch";
import type { MapRow3, SpaceView } from "#wasm/api";
import { loadSpace, solid } from "#wasm/space";
import { Head, type Heading, Parameters } from "../../kit/frame/frame";
import frameCss from "../../kit/frame/frame.module.css";
import layout from "../../kit/frame/layout.module.css";
import { flag, optional, parts, text } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { useValue } from "../../kit/workers";
import { VIEW } from "../space/eye";
import { hasPreset, presetMaps, spaceHref } from "../space/tool-link";
import { type Layer, MeetView } from "./meet-view";
import { findingOf, inner, isFlat, placed } from "./meets";
import { OWN, OWN_FIELD, OwnShapes } from "./own-shape";
import css from "./page.module.css";
import { MeetProduct } from "./product";
import { type Met, useMeet } from "./use-intersection";

const OWN_ID = "own";
const CLOUD = 40_000;
/** Places in the palette. */
const COLOURS = { first: 1, second: 0 } as const;

interface Pair {
  first: MapRow3[];
  second: MapRow3[];
  names: readonly [string, string];
  /** What is proved of it; null where nobody has looked. */
  known: { name: string; isAttractor: boolean; why: string } | null;
}

/** What stands in its address. */
export const STATE = {
  which: kept("0", text(/[01]|own/)),
  own: kept(OWN, OWN_FIELD),
  shown: kept({ first: true, second: true }, parts({ first: flag, second: flag })),
  view: kept<SpaceView | null>(null, optional(VIEW)),
};

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** The question that the paper ends with. */
export function Page(heading: Heading) {
  const examples = useMemo(() => solid.meetExamples(), []);
  const [which, setWhich] = useKept("which", ...STATE.which);
  const [asked, setOwn] = useKept("own", ...STATE.own);
  // An address may name shapes that there are not.
  const own = [asked.first, asked.second].every(hasPreset) ? asked : OWN;
  const pair = useMemo((): Pair => {
    const example = examples[Number(which)];
    if (which !== OWN_ID && example) {
      const { name, first, second, isAttractor, why } = example;
      return { first, second, names: ["First shape", "Second shape"], known: { name, isAttractor, why } };
    }
    const name = (id: string) => solid.presets3().find((preset) => preset.id === id)?.name ?? id;
    return {
      first: presetMaps(own.first),
      second: placed(presetMaps(own.second), own.scale, own.shift),
      names: [name(own.first), name(own.second)],
      known: null,
    };
  }, [examples, which, own]);
  const met = useMeet(pair.first, pair.second);
  const current = met?.of.first === pair.first && met.of.second === pair.second ? met : null;
  return (
    <>
      <Head
        {...heading}
        badge="open"
        studio={{
          href: spaceHref([
            { name: pair.names[0], maps: pair.first },
            { name: pair.names[1], maps: pair.second },
          ]),
          label: "Open both in Space",
        }}
      >
        <p>
          Move an attractor and it is one again; project it the right way and it is one again. What of the
          part that two of them share? The paper ends with this question, and nobody has a general answer. For
          two shapes whose maps all have the same matrix it can be worked out, pair by pair of maps. Here it
          is done twice: once the intersection is an attractor, and once it is proved to be none.
        </p>
      </Head>
      <section class={`${frameCss["figure-live"]} ${css["live"]}`} data-testid="live" aria-label="The figure">
        <div class={layout["choice"]}>
          <Segmented
            label="Which two shapes"
            value={which}
            onChange={setWhich}
            options={[
              ...examples.map(({ name, isAttractor }, i) => ({
                value: String(i),
                label: isAttractor ? "One that is" : "One that is not",
                description: name,
              })),
              { value: OWN_ID, label: "Your own", description: "Any two of the gallery" },
            ]}
          />
        </div>
        {which === OWN_ID && <OwnShapes own={own} onChange={setOwn} />}
        <Meeting key={which} pair={pair} met={current ?? met} stale={current === null} />
        <Verdict pair={pair} met={current} />
        <MeetProduct found={(current ?? met)?.found ?? null} stale={current === null} />
      </section>
      <Foot pair={pair} met={current} />
    </>
  );
}

interface MeetingProps {
  pair: Pair;
  met: Met | null;
  stale: boolean;
}

/** Both shapes, and what they share. */
function Meeting({ pair, met, stale }: MeetingProps) {
  const [shown, setShown] = useKept("shown", ...STATE.shown);
  const flat = isFlat(pair.first) && isFlat(pair.second);
  const whole = useMemo((): SpaceView => {
    const objects = [
      { name: "first", maps: pair.first },
      { name: "second", maps: pair.second },
    ];
    const view = solid.defaultView({ objects, light: solid.defaultSpace().light });
    return flat ? { ...view, turn: 0, tilt: Math.PI / 2 } : view;
  }, [pair, flat]);
  const [turned, setTurned] = useKept("view", ...STATE.view);
  // Turned by hand it stays turned; how near it is hangs on the shapes.
  const view = turned ? { ...whole, turn: turned.turn, tilt: turned.tilt } : whole;
  const first = useCloud(pair.first, 1);
  const second = useCloud(pair.second, 2);
  const shared = met?.found?.points;
  const layers = useMemo((): Layer[] => {
    const list: Layer[] = [];
    if (shown.first) list.push({ name: "first", points: first, colour: COLOURS.first, size: 1.2 });
    if (shown.second) list.push({ name: "second", points: second, colour: COLOURS.second, size: 1.2 });
    if (shared && !stale) list.push({ name: "shared", points: shared, colour: "ink", size: flat ? 3 : 1.7 });
    return list;
  }, [shown, first, second, shared, stale, flat]);
  const [a, b] = pair.names;
  const colours = palette(useValue(dark) ? "dark" : "light");
  return (
    <div class="stack">
      <MeetView
        layers={layers}
        view={view}
        fitted={flat}
        onView={setTurned}
        label={`${a} and ${b}, and what they share, drawn darker and thicker.`}
      />
      <ul class={css["meet-key"]}>
        <li>
          <span
            class={css["meet-swatch"]}
            style={{ background: colours[COLOURS.first] }}
            aria-hidden="true"
          />
          <Switch checked={shown.first} onChange={(on) => setShown({ ...shown, first: on })}>
            {a}, {pair.first.length} maps
          </Switch>
        </li>
        <li>
          <span
            class={css["meet-swatch"]}
            style={{ background: colours[COLOURS.second] }}
            aria-hidden="true"
          />
          <Switch checked={shown.second} onChange={(on) => setShown({ ...shown, second: on })}>
            {b}, {pair.second.length} maps
          </Switch>
        </li>
        <li>
          <span class={`${css["meet-swatch"]} ${css["shared"]}`} aria-hidden="true" />
          <span>What they share, thick</span>
        </li>
      </ul>
    </div>
  );
}

function useCloud(maps: MapRow3[], seed: number): Float32Array {
  return useMemo(() => {
    try {
      return solid.attractor3(maps, { points: CLOUD, seed }).positions;
    } catch {
      return new Float32Array();
    }
  }, [maps, seed]);
}

/** What it comes to, in words. */
function Verdict({ pair, met }: { pair: Pair; met: Met | null }) {
  const { title, text } = verdictWords(pair, met);
  return (
    <div class={css["meet-verdict"]} role="status">
      <p>
        <strong>{title}</strong>
      </p>
      <p>{text}</p>
    </div>
  );
}

function verdictWords(
  { first, second, names, known }: Pair,
  met: Met | null,
): { title: string; text: string } {
  if (!met) return { title: "Looking …", text: "" };
  const attractor = met.found?.attractor ?? null;
  const count = attractor?.length ?? 0;
  if (known)
    return {
      title: known.isAttractor
        ? `${known.name}: an attractor, of ${count} maps.`
        : `${known.name}: no attractor of finitely many affine maps.`,
      text: known.why,
    };
  const within = inner(first, second);
  if (within) {
    const [less, more] = within === "first" ? names : [names[1], names[0]];
    const maps = within === "first" ? first : second;
    return {
      title: `It is an attractor, of ${maps.length} maps.`,
      text: `Every map of ${less} is a map of ${more}, too. So the one lies in the other, and is what they share.`,
    };
  }
  if (met.found === null)
    return {
      title: "This is part of the open question.",
      text: `${met.problem ?? ""} Where the maps do not share one matrix, no general way is known.`,
    };
  const { shifts } = met.found;
  switch (findingOf(met.found)) {
    case "apart":
      return { title: "They do not meet.", text: "No way through the pairs of maps goes on for ever." };
    case "one":
      return {
        title: `It is an attractor, of ${count} maps.`,
        text: "All ways lead from no shift back to none, so that the shared maps make it by themselves.",
      };
    default:
      return {
        title: "The construction finds no single system.",
        text:
          `Ways lead from no shift to others: there are ${shifts.length} in all. The intersection is a union of as many ` +
          "kinds of pieces, each made of copies of the others. It may be an attractor all the same, of other maps: this " +
          "is where the question is open.",
      };
  }
}

function Foot({ pair, met }: { pair: Pair; met: Met | null }) {
  const found = met?.found;
  return (
    <div class={frameCss["figure-foot"]}>
      <section class={frameCss["figure-found"]} aria-labelledby="figure-found">
        <h2 id="figure-found">What is known</h2>
        <p>
          Where all maps share one matrix and only finitely many shifts matter, the intersection is drawn by a
          walk on the graph above. If no way leaves knot 0, the pairs at it are the maps of the intersection,
          and it is an attractor. If ways leave it, the intersection is a union of pieces of several kinds.
          That need not be an attractor of any finite number of maps, as the bar and the dust show, but it
          may.
        </p>
        <p>
          So the answer to the paper’s question is: not always. Which intersections are attractors, and for
          maps with different matrices even how to tell, is open.
        </p>
      </section>
      <section aria-labelledby="figure-parameters">
        <h2 id="figure-parameters">Parameters</h2>
        <Parameters
          of={[
            { name: pair.names[0], value: `${pair.first.length} maps` },
            { name: pair.names[1], value: `${pair.second.length} maps` },
            { name: "Shifts that go on for ever", value: found ? String(found.shifts.length) : "–" },
            { name: "Pairs of maps on them", value: found ? String(found.arrows.length) : "–" },
            {
              name: "Maps of the intersection",
              value: found ? (found.attractor ? String(found.attractor.length) : "none found") : "–",
            },
          ]}
        />
      </section>
      <section aria-labelledby="figure-paper">
        <h2 id="figure-paper">In the paper</h2>
        <blockquote>
          The question that still remain[s] is whether the intersection of two fractals could also be
          represented as a fractal
        </blockquote>
        <p>The last sentence of its section 4. The construction and both examples are Frond’s own.</p>
      </section>
    </div>
  );
}
