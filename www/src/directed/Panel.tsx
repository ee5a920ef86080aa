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
import * as messages from "./messages";
import { save, saveAifs } from "./save";
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
      <section class={endsCss["ends"]} aria-label={messages.twoShapes}>
        <Card end="a" editing={editing === "a"} onEdit={toggle} choose={choose} />
        <SwapEnds
          onSwap={() => {
            edit(swapDirected);
            const now = scene.peek().directed;
            if (now) announce(messages.swapped(now.a.name, now.b.name));
          }}
        />
        <Card end="b" editing={editing === "b"} onEdit={toggle} choose={choose} />
      </section>
      {editing && open && (
        <Editor
          key={editing}
          title={messages.statesOf(editing.toUpperCase())}
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
      <section class="stack" aria-label={messages.saveThisShape}>
        <div class={css["files"]}>
          <Button description={messages.documentWithBothShapes} onClick={save}>
            {messages.saveAsJson}
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
        label={messages.editStates(upper)}
        pressed={editing}
        onClick={() => onEdit(end)}
      />
      <Menu
        label={messages.moreFor(upper)}
        items={[
          { label: messages.chooseAnother, icon: "grid", onSelect: () => choose(end) },
          {
            label: messages.saveThisShape,
            icon: "check",
            onSelect: async () => {
              const { keepDirected } = await import("#document/own-shapes");
              const text = keepDirected(shape) ?? messages.isKept(shape.name);
              notify({ kind: "info", text });
            },
          },
          { label: messages.saveAsAifs, icon: "save", onSelect: () => void saveAifs(shape) },
          {
            label: messages.alsoAs(other),
            icon: "copy",
            onSelect: () => {
              edit((before) => directedAtBoth(before, end));
              announce(messages.bothShapes(shape.name));
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
        <h2 id="directed-way">{messages.shapesSeveralStates}</h2>
      </header>
      <p class="hint">{same.value ? messages.bothEndsSameShape : messages.eachStateMadeCopies}</p>
      {!same.value && <Problem words={facts?.problem ?? null} />}
      {facts?.problem != null && outlines.value && (
        <div class="row">
          <p>{messages.bothOutlinesSoThey}</p>
          <Button onClick={() => void asClosedCurves()}>{messages.asClosedCurves}</Button>
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
              <p>{messages.provedFernFrondStays}</p>
              <Button onClick={() => void plantInstead()}>{messages.useFrond}</Button>
            </div>
          )}
          {facts.linear && (
            <div class="row">
              <p>{messages.provedBlendedEntryBy}</p>
              <Button onClick={() => edit((before) => ({ ...before, mode: "linear" }))}>
                {messages.blendEntryByEntry}
              </Button>
            </div>
          )}
        </div>
      )}
    </section>
  );
}

const HALF_TURNS: readonly { value: HalfTurns; label: string; description: string }[] = [
  { value: "signs", label: messages.byEq6, description: messages.bySignsAnglesAs },
  { value: "counterclockwise", label: messages.left, description: messages.allCounterClockwise },
  { value: "clockwise", label: messages.right, description: messages.allClockwise },
];
const halfTurns = computed(() => scene.value.directed?.halfTurns ?? "signs");

/** Half a turn is as short either way: says so, and offers them. */
function HalfTurnsChoice({ maps }: { maps: number }) {
  return (
    <>
      <p>{messages.halfTurnsOf(maps)}</p>
      <ChoiceRow
        label={messages.halfTurns}
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
    label: messages.byRotation,
    description: messages.polarEachMapRotates,
  },
  { value: "linear", label: messages.entryByEntry, description: messages.linearMatrixEntriesBlended },
];
const COLOURINGS: readonly { value: Colouring; label: string; description: string }[] = [
  { value: "map", label: messages.map, description: messages.oneColourForEach },
  {
    value: "address",
    label: messages.state,
    description: messages.oneColourForEachState,
  },
  { value: "density", label: messages.plain, description: messages.oneColour },
];
const mode = computed(() => scene.value.mode);
const colouring = computed(() => (scene.value.colouring === "grid" ? "density" : scene.value.colouring));

function Look() {
  return (
    <section class="stack" aria-label={messages.motionAndColour}>
      <ChoiceRow
        label={messages.blendMaps}
        value={mode.value}
        options={MODES}
        onChange={(next) => edit((before) => ({ ...before, mode: next }))}
      />
      <ChoiceRow
        label={messages.colourBy}
        value={colouring.value}
        options={COLOURINGS}
        onChange={(next) => edit((before) => ({ ...before, colouring: next }))}
      />
    </section>
  );
}
