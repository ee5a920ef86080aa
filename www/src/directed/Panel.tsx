import { computed } from "@preact/signals";
import { useState } from "preact/hooks";
import {
  directedAtBoth,
  type End,
  sameDirected,
  setStates,
  swapDirected,
  withHalfTurns,
} from "#document/directed/changes";
import { directedShapes } from "#document/directed/directed";
import { asClosedCurves, plantInstead, plantMayHelp } from "#document/directed/outlines";
import { announce, notify } from "#document/notice";
import { edit, endGesture, scene } from "#document/scene";
import { BackToSystems } from "#stage/curve/BackToSystems";
import { apartAt, directedProblem, type WayFacts, wayFacts } from "#stage/directed/known";
import { Button, IconButton } from "#ui/controls/Button";
import { Menu } from "#ui/overlay/Menu";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { Problem } from "#ui/panel/Problem";
import { EndCard, SwapEnds } from "#ui/shapes/EndCard";
import endsCss from "#ui/shapes/ends.module.css";
import type { Colouring, HalfTurns, Mode } from "#wasm/api";
import css from "./directed.module.css";
import { Editor } from "./Editor";
import { Way } from "./Found";
import { DirectedMap } from "./map/Map";
import { save } from "./save";
import { DirectedThumb } from "./Thumb";
import { sizeWords, stateWords } from "./words";

interface DirectedPanelProps {
  /** Opens the gallery for an end. */
  choose: (end: End) => void;
}

/** The morph of two graph-directed shapes: its ends, their states and maps, and what is known of the way. */
export function DirectedPanel({ choose }: DirectedPanelProps) {
  const [editing, setEditing] = useState<End | null>(null);
  const toggle = (end: End) => setEditing((now) => (now === end ? null : end));
  const open = editing && directedShapes.value?.[editing];
  return (
    <>
      <section class={endsCss["ends"]} aria-label="The two shapes">
        <Card end="a" editing={editing === "a"} onEdit={toggle} choose={choose} />
        <SwapEnds
          onSwap={() => {
            edit(swapDirected);
            const now = scene.peek().directed;
            if (now) announce(`Swapped: from ${now.a.name} to ${now.b.name}.`);
          }}
        />
        <Card end="b" editing={editing === "b"} onEdit={toggle} choose={choose} />
      </section>
      {editing && open && (
        <Editor
          key={editing}
          title={`The states of ${editing.toUpperCase()}`}
          system={open}
          problem={directedProblem.value}
          onChange={({ states }, field) =>
            edit(
              (before) => setStates(before, editing, states),
              field === undefined ? {} : { gesture: `${editing}-${field}` },
            )
          }
          onDone={endGesture}
        />
      )}
      <OnTheWay />
      {mapped.value && <DirectedMap />}
      <Look />
      <section class="stack" aria-label="Save this shape">
        <div class={css["files"]}>
          <Button
            description="The document, with both shapes, their states and maps: it opens again"
            onClick={save}
          >
            Save as JSON
          </Button>
          <BackToSystems />
        </div>
      </section>
    </>
  );
}

interface CardProps extends DirectedPanelProps {
  end: End;
  editing: boolean;
  onEdit: (end: End) => void;
}

function Card({ end, editing, onEdit, choose }: CardProps) {
  const shape = directedShapes.value?.[end];
  if (!shape) return null;
  const [upper, other] = end === "a" ? ["A", "B"] : ["B", "A"];
  return (
    <EndCard
      end={end}
      name={shape.name}
      note={sizeWords(shape)}
      count={stateWords(shape)}
      picture={<DirectedThumb states={shape.states} />}
      editing={editing}
      onChoose={() => choose(end)}
    >
      <IconButton
        kind="quiet"
        icon="edit"
        label={`Edit the states of ${upper}`}
        pressed={editing}
        onClick={() => onEdit(end)}
      />
      <Menu
        label={`More for shape ${upper}`}
        items={[
          { label: "Choose another …", icon: "grid", onSelect: () => choose(end) },
          {
            label: "Keep this shape",
            icon: "check",
            onSelect: async () => {
              const { keepDirected } = await import("#document/own-shapes");
              const text = keepDirected(shape) ?? `${shape.name} is kept: it is in the gallery, under Yours.`;
              notify({ kind: "info", text });
            },
          },
          {
            label: `Use as ${other} too`,
            icon: "copy",
            onSelect: () => {
              edit((before) => directedAtBoth(before, end));
              announce(`${shape.name} is now at both ends.`);
            },
          },
        ]}
      />
    </EndCard>
  );
}

const same = computed(() => {
  const now = directedShapes.value;
  return now !== null && sameDirected(now);
});

/** Whether there is a way to be drawn in the map of where it holds together. */
const mapped = computed(() => !same.value && wayFacts.value?.match != null);

const outlines = computed(() => {
  const now = directedShapes.value;
  return now?.a.outline !== undefined && now.b.outline !== undefined;
});

const helped = computed(() => {
  const now = directedShapes.value;
  return now !== null && plantMayHelp(now) !== null;
});

/** Whether it falls apart on the way, or nothing is proved of it in the time that there is. */
function doubtful({ proof, ended }: Pick<WayFacts, "proof" | "ended">, apart: number | null): boolean {
  return apart !== null || ended || proof?.states[0]?.kind === "open";
}

/** How the graphs are matched, and what is shown of every moment between them. */
function OnTheWay() {
  const facts = wayFacts.value;
  return (
    <section class="stack" aria-labelledby="directed-way">
      <header class="section-head">
        <h2 id="directed-way">Shapes of several states</h2>
      </header>
      <p class="hint">
        {same.value
          ? "Both ends are the same shape: choose another for one of them to have a morph."
          : "Each state is made of copies of states. On the way each map of a state becomes a map of another, and so does what they copy. The way goes straight through the map below."}
      </p>
      {!same.value && <Problem words={facts?.problem ?? null} />}
      {facts?.problem != null && outlines.value && (
        <div class="row">
          <p>Both are outlines, which morph with each other as closed curves.</p>
          <Button onClick={() => void asClosedCurves()}>As closed curves</Button>
        </div>
      )}
      {!same.value && facts?.match && (
        <div class={css["way"]}>
          <Way proof={facts.proof} match={facts.match} apart={apartAt.value} ended={facts.ended} />
          {facts.match.halfTurns > 0 && mode.value === "polar" && (
            <HalfTurnsChoice maps={facts.match.halfTurns} />
          )}
          {helped.value && doubtful(facts, apartAt.value) && (
            <div class="row">
              <p>The fern “Frond” stays in one piece all the way, proved.</p>
              <Button onClick={() => void plantInstead()}>Take “Frond”</Button>
            </div>
          )}
          {facts.linear && (
            <div class="row">
              <p>Number by number it stays in one piece all the way, proved.</p>
              <Button onClick={() => edit((before) => ({ ...before, mode: "linear" }))}>Go linear</Button>
            </div>
          )}
        </div>
      )}
    </section>
  );
}

const HALF_TURNS: readonly { value: HalfTurns; label: string; description: string }[] = [
  { value: "signs", label: "By eq. 6", description: "As the signs of the angles have it in the paper" },
  { value: "counterclockwise", label: "Left", description: "Counter-clockwise, all of them" },
  { value: "clockwise", label: "Right", description: "Clockwise, all of them" },
];
const halfTurns = computed(() => scene.value.directed?.halfTurns ?? "signs");

/** Half a turn is as short either way: says so, and offers them. */
function HalfTurnsChoice({ maps }: { maps: number }) {
  return (
    <>
      <p>
        {maps === 1 ? "1 map makes" : `${maps} maps make`} exactly half a turn, which is as short either way.
      </p>
      <ChoiceRow
        label="Half turns"
        value={halfTurns.value}
        options={HALF_TURNS}
        onChange={(next) => edit((before) => withHalfTurns(before, next))}
      />
    </>
  );
}

const MODES: readonly { value: Mode; label: string; description: string }[] = [
  {
    value: "polar",
    label: "Turning",
    description: "Polar: each map turns and stretches on its own, so pieces keep their size",
  },
  { value: "linear", label: "Linear", description: "Number by number: ends that meet stay together" },
];
const COLOURINGS: readonly { value: Colouring; label: string; description: string }[] = [
  { value: "map", label: "Map", description: "One colour for each map of the shape" },
  {
    value: "address",
    label: "State",
    description: "One colour for each state that is copied after three maps",
  },
  { value: "density", label: "Plain", description: "One colour" },
];
const mode = computed(() => scene.value.mode);
const colouring = computed(() => (scene.value.colouring === "grid" ? "density" : scene.value.colouring));

function Look() {
  return (
    <section class="stack" aria-label="Motion and colour">
      <ChoiceRow
        label="Motion"
        value={mode.value}
        options={MODES}
        onChange={(next) => edit((before) => ({ ...before, mode: next }))}
      />
      <ChoiceRow
        label="Colour by"
        value={colouring.value}
        options={COLOURINGS}
        onChange={(next) => edit((before) => ({ ...before, colouring: next }))}
      />
    </section>
  );
}
