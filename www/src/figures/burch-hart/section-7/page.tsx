import { useMemo, useRef } from "preact/hooks";
import { directedChoices } from "#directed/choices";
import { Editor } from "#directed/Editor";
import { Answer, Remarks, Way } from "#directed/Found";
import { madeOf } from "#directed/systems";
import { fixed } from "#format/numbers";
import { RESOLUTION, verdictPhrase } from "#format/verdict";
import { union } from "#geometry/boxes";
import { Select } from "#ui/controls/Select";
import type { DirectedIfs, DirectedShape, StateConnectedness } from "#wasm/api";
import { loadCurves, rough } from "#wasm/curve";
import { directed, loadDirected } from "#wasm/directed";
import { useDirected } from "../../kit/directed/ask";
import { look } from "../../kit/directed/look";
import { StatePicture } from "../../kit/directed/state-picture";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { directedHref } from "../../kit/frame/studio-link";
import { Chip, VerdictChip } from "../../kit/frame/verdict";
import { tex } from "../../kit/notation/tex";
import { oneOf, text, whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { Time, useTime } from "../../kit/time/time";
import { SYSTEM } from "./address";
import css from "./page.module.css";

const PRESET = text(/[a-z0-9-]{1,30}/);

/** What stands in its address. */
export const STATE = {
  from: kept("snowflake", PRESET),
  to: kept("crystal", PRESET),
  own: kept(null, SYSTEM),
  maps: kept<Mode>("linear", oneOf(["polar", "linear"])),
  level: kept(0, whole(0, 6)),
};

/** What must be there before it is shown. */
export const needs = [loadDirected, loadCurves];

type Mode = "polar" | "linear";
const PROOF_EPSILON = 1 / 100;

/** Shapes of several states, made of copies of each other, and the way between two of them. */
export function Page(heading: Heading) {
  const [from, setFrom] = useKept("from", ...STATE.from);
  const [to, setTo] = useKept("to", ...STATE.to);
  const [own, setOwn] = useKept("own", ...STATE.own);
  const [mode, setMode] = useKept("maps", ...STATE.maps);
  const [level, setLevel] = useKept("level", ...STATE.level);
  const time = useTime(0);
  const first = useMemo(() => own ?? systemOf(from, STATE.from[0]), [own, from]);
  const last = useMemo(() => systemOf(to, STATE.to[0]), [to]);
  const way = useMemo(() => wayOf(first, last, mode), [first, last, mode]);
  const system = useMemo(() => way.at(time.t), [way, time.t]);
  const seen = useMemo(() => look(system), [system]);
  const problem = way.problem ?? (typeof seen === "string" && time.t === 0 ? seen : null);
  const lost = typeof seen === "string";
  // What has no attractor leaves what there was.
  const held = useRef({ system, seen });
  if (!lost) held.current = { system, seen };
  const shown = held.current;
  const facts = typeof shown.seen === "string" ? null : shown.seen;
  const boxes = facts?.boxes ?? [];
  const asked = useMemo(() => (lost ? null : { system, epsilon: RESOLUTION }), [system, lost]);
  const verdicts = useDirected("verdicts", asked, 1);
  const stale = verdicts?.about !== asked;
  const answers: readonly StateConnectedness[] = verdicts?.result ?? [];
  const proofTask = useMemo(
    () => (way.problem === null ? { from: first, to: last, mode, epsilon: PROOF_EPSILON } : null),
    [way, first, last, mode],
  );
  const proof = useDirected("certify", proofTask, 1);
  const proved = proof?.about === proofTask ? (proof?.result ?? null) : null;
  const opened = opening(shapeOf(from, own), shapeOf(to, null), mode, time.t);
  const story = own === null && from === "frond" && to === "edges-maple";
  const choose = (id: string) => {
    setFrom(id);
    setOwn(null);
    time.go(0);
  };
  const box = union([...way.boxes, ...(boxes[0] ? [boxes[0]] : [])]);
  const dimension = facts?.facts.states[0]?.dimension;
  return (
    <Frame
      {...heading}
      {...(opened ? { studio: opened } : {})}
      lead={
        <p>
          A shape may be made of copies of other shapes, and these of copies of it: a graph says what copies
          what. The paper asks how such systems could be morphed. Here each map of a state becomes a map of
          another state, and so does what they copy; a state that is to become several is split, which changes
          no shape. A fern becomes an outline in one piece: the way around it becomes the way around the leaf.
          Morph draws, over u and v, where the shape between two of them holds together.
        </p>
      }
      found={
        <>
          <Answer of={lost ? undefined : answers[0]} />
          <Way proof={proved} match={way.match} />
        </>
      }
      parameters={[
        { name: "States at this moment", value: String(system.states.length) },
        {
          name: "Maps at this moment",
          value: String(system.states.reduce((sum, maps) => sum + maps.length, 0)),
        },
        ...(dimension === undefined
          ? []
          : [{ name: "Dimension of the shape, if copies do not overlap", value: fixed(dimension, 4) }]),
        { name: "A state", value: [tex`K_i = \bigcup_{e} f_e(K_{j(e)})`] },
        { name: "Resolution of the verdicts", symbol: "ε", value: "1/600 of each state" },
      ]}
      captions={[
        "The recurrent iterated function systems (RIFS) constrains an iterated function system with a directed graph controlling map composition. Interpolation of RIFS attractors poses the problem of interpolating directed graphs, possibly even with a different number of vertices.",
      ]}
      own
      reconstructed="Section 7.1 asks the question and prints no example. The shapes are from the literature (Koch 1904, Heighway, Penrose and Robinson, Rauzy 1982, McWorter 1987) and Frond’s own; graph-directed systems and their dimension are those of Mauldin & Williams (1988)."
    >
      <div class={layout["controls"]}>
        <PresetChoice label="First" value={from} onChange={choose} />
        <PresetChoice label="Last" value={to} onChange={setTo} />
        <Choice
          label="Maps"
          options={[
            {
              value: "polar",
              label: "turn",
              description: "By equation 6: the angle turns, the stretch goes along",
            },
            {
              value: "linear",
              label: "go straight",
              description:
                "Number by number: where ends of copies meet in both shapes, they can meet all the way",
            },
          ]}
          value={mode}
          onChange={setMode}
        />
        <SliderControl
          label="Colours by state, after"
          name="Colours tell the state that is copied after so many maps; 0: the map"
          range={[0, 6]}
          whole
          value={level}
          text={level === 0 ? "off" : level === 1 ? "1 map" : `${level} maps`}
          onChange={setLevel}
        />
      </div>
      {!story && (
        <p class={layout["hint"]}>
          <button
            type="button"
            class="button quiet"
            onClick={() => {
              choose("frond");
              setTo("edges-maple");
              setMode("linear");
            }}
          >
            From a fern to a leaf
          </button>
        </p>
      )}
      <Time time={time} words={answers[0] && !stale ? verdictPhrase(answers[0]) : ""} />
      {lost && time.t > 0 && <p class={layout["hint"]}>{String(seen)}</p>}
      <div class={layout["two-columns"]}>
        <div>
          {facts && (
            <StatePicture
              system={shown.system}
              state={0}
              box={box}
              level={level}
              label={`The shape at t = ${fixed(time.t)}: ${answers[0] ? verdictPhrase(answers[0]) : "looking"}`}
            />
          )}
          {lost ? (
            <Chip tone="unknown" text="No attractor" aside="the picture is of the maps before" />
          ) : (
            answers[0] && <VerdictChip answer={plain(answers[0])} stale={stale} />
          )}
        </div>
        <Editor
          title="The maps of the first shape"
          system={first}
          problem={problem}
          onChange={(next) => {
            setOwn(next);
            time.go(0);
          }}
        />
      </div>
      <h2>The states</h2>
      <div class={css["states"]}>
        {shown.system.states.slice(0, MOST_SHOWN).map((maps, state) => {
          const own = boxes[state];
          const answer = answers[state];
          return (
            <section key={state} class={css["state"]} aria-label={`State ${state + 1}`}>
              <h3>State {state + 1}</h3>
              {own && (
                <StatePicture system={shown.system} state={state} box={own} level={level} label={null} />
              )}
              <p class={css["made"]}>{madeOf(maps)}</p>
              {answer && !lost && <VerdictChip answer={plain(answer)} stale={stale} />}
            </section>
          );
        })}
      </div>
      {shown.system.states.length > MOST_SHOWN && (
        <p class={layout["hint"]}>… and {shown.system.states.length - MOST_SHOWN} more.</p>
      )}
      {facts && <Remarks {...facts.facts} />}
    </Frame>
  );
}

let made: ReturnType<typeof directedChoices> | null = null;

/** The shapes of the page. */
function choices() {
  made ??= directedChoices(rough.curvePresets(), null);
  return made;
}

/** A shape as a document has it: that of the gallery, or one's own. */
function shapeOf(id: string, own: DirectedIfs | null): DirectedShape {
  if (own) return { name: "Own shape", states: own.states };
  const found = choices().find((preset) => preset.id === id);
  if (!found) return { name: id, states: [] };
  const { name, system, outline } = found;
  return outline
    ? directed.outlineShape(outline.name, outline.curve, [-0.5, 0, 0.5, 1])
    : { preset: id, name, ...system };
}

/** The system of a name; an address may have one that there is not. */
function systemOf(id: string, otherwise: string): DirectedIfs {
  const presets = choices();
  const found =
    presets.find((preset) => preset.id === id) ?? presets.find((preset) => preset.id === otherwise);
  return found?.system ?? { states: [] };
}

/** As many states have a picture of their own. */
const MOST_SHOWN = 8;

/** A state in the words for shapes: it has no components of its own. */
const plain = (state: StateConnectedness) => ({ ...state, components: [], count: 1 });

/** A shape of the gallery, at one end. */
function PresetChoice(props: { label: string; value: string; onChange: (id: string) => void }) {
  return (
    <label>
      {props.label}{" "}
      <Select value={props.value} onChange={(event) => props.onChange(event.currentTarget.value)}>
        {choices().map(({ id, name }) => (
          <option key={id} value={id}>
            {name}
          </option>
        ))}
      </Select>
    </label>
  );
}

/** The shapes of the page as a document, for the studio; none where they are no shapes, or too large for a link. */
function opening(a: DirectedShape, b: DirectedShape, mode: Mode, t: number) {
  try {
    return { href: directedHref({ a, b, mode, t }), label: "Open in Morph" };
  } catch {
    return undefined;
  }
}

/** The way between two systems, or the first alone and why there is none. */
function wayOf(from: DirectedIfs, to: DirectedIfs, mode: Mode) {
  const boxes = [from, to].flatMap((system) => {
    const seen = look(system);
    return typeof seen === "string" ? [] : seen.boxes.slice(0, 1);
  });
  try {
    const match = directed.matchDirected(from, to);
    // At the ends nothing is split: the shapes are as they were chosen.
    const at = (t: number) =>
      t === 0 ? from : t === 1 ? to : directed.interpolateDirected(from, to, { u: t, v: t, mode });
    return { at, match, boxes, problem: null };
  } catch (problem) {
    return {
      at: () => from,
      match: null,
      boxes,
      problem: problem instanceof Error ? problem.message : String(problem),
    };
  }
}
