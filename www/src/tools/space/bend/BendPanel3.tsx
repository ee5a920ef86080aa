import { endGesture } from "#document/scene";
import { changeSpace } from "#document/space/edits";
import { chosen, spaceReady, timeline } from "#document/space/space";
import { formatNumber } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { SliderField } from "#ui/controls/SliderField";
import { Switch } from "#ui/controls/Switch";
import type { SpaceBend } from "#wasm/api";
import { object } from "../shape/now";
import { showWhole } from "../stage/actions";
import { stageSize } from "../stage/state";
import { BentHolds } from "./BentHolds";
import css from "./bend.module.css";
import {
  asExample,
  atRest,
  EXAMPLES,
  FARTHEST,
  isAtRest,
  LEAST_SIDE,
  MOST_ROUGHNESS,
  MOST_SIDE,
  nameOf,
  withBend,
  withDetail,
  withLocality,
  withMoved,
  withSizes,
} from "./changes";
import { bend, changeBend, handles, lead, room, sidesOf, sizeOf } from "./now";

/** As deep as it begins, where the shape allows it. */
const USUAL_DETAIL = 4;

/** A lattice around the chosen object, and how its small parts answer. */
export function BendPanel3() {
  return spaceReady.value ? <Parts /> : null;
}

function Parts() {
  const now = bend.value;
  return now ? (
    <>
      <Lattice now={now} />
      <BentHolds now={now} />
      <Answer now={now} />
      <Chosen now={now} />
      <Last now={now} />
    </>
  ) : (
    <Begin />
  );
}

function Begin() {
  const box = room.value;
  const name = object.value?.name ?? "The object";
  return (
    <section class="stack" aria-label="Begin to bend">
      <p class="hint">
        A lattice of handles around {name}: pull one, and not only what is near it follows. Every part, at
        every scale, answers in its own place.
      </p>
      <Button
        kind="primary"
        disabled={box === null}
        onClick={() => {
          if (!box) return;
          const first = atRest([3, 3, 3], Math.min(USUAL_DETAIL, Math.max(1, box.deepest - 1)));
          const [corner] = EXAMPLES;
          const bent = corner ? asExample(first, corner, unit(box)) : first;
          if (changeSpace((space) => withBend(space, chosen.peek(), bent))) showAll();
        }}
      >
        Bend it
      </Button>
    </section>
  );
}

/** The view goes where all handles are seen, if they are not. */
function showAll(): void {
  const { width, height } = stageSize.peek();
  const room = 24;
  const inside = (at: (typeof handles.value)[number]) =>
    at !== null && at.x > room && at.y > room && at.x < width - room && at.y < height - room;
  if (!handles.peek().every(inside)) showWhole();
}

/** The sides of the box, the longest of which is 1. */
function unit(box: Parameters<typeof sidesOf>[0]): [number, number, number] {
  const size = sizeOf(box);
  const [x, y, z] = sidesOf(box);
  return [x / size, y / size, z / size];
}

function Lattice({ now }: { now: SpaceBend }) {
  const box = room.value;
  return (
    <section class="stack" aria-label="Lattice">
      <div class="section-head">
        <h2>Lattice</h2>
        <Button
          kind="quiet"
          icon="reset"
          disabled={isAtRest(now)}
          onClick={() => changeBend((before) => ({ ...before, moves: before.moves.map(() => [0, 0, 0]) }))}
        >
          Put all back
        </Button>
      </div>
      <div class={css["bend-examples"]}>
        {EXAMPLES.map((example) => (
          <Button
            key={example.id}
            description={example.about}
            disabled={box === null}
            onClick={() => {
              if (box && changeBend((before) => asExample(before, example, unit(box)))) showAll();
            }}
          >
            {example.label}
          </Button>
        ))}
      </div>
      <p class="row-name">Handles along each axis</p>
      <div class={css["bend-numbers"]}>
        {(["x", "y", "z"] as const).map((name, axis) => (
          <NumberField
            key={name}
            label={`Handles along ${name}`}
            symbol={name}
            value={now.sizes[axis] ?? LEAST_SIDE}
            min={LEAST_SIDE}
            max={MOST_SIDE}
            whole
            terse
            onChange={(next) => {
              const sizes = now.sizes.map((size, k) => (k === axis ? next : size)) as SpaceBend["sizes"];
              changeBend((before) => withSizes(before, sizes), `bend size ${name}`);
            }}
            onDone={endGesture}
          />
        ))}
      </div>
    </section>
  );
}

function Answer({ now }: { now: SpaceBend }) {
  const box = room.value;
  const deepest = box?.deepest ?? now.ke;
  return (
    <section class="stack" aria-label="How the parts answer">
      <div class="section-head">
        <h2>How the parts answer</h2>
      </div>
      <SliderField
        label="Locality"
        symbol="kb"
        value={now.kb}
        max={now.ke}
        step={0.1}
        words={now.kb >= now.ke ? "plain" : `${formatNumber(now.kb, 1)} of ${formatNumber(now.ke, 1)}`}
        ends={["scattered: every part answers", "plain"]}
        onChange={(next) => {
          changeBend((before) => withLocality(before, next), "bend kb");
        }}
      />
      <SliderField
        label="Roughness"
        symbol="δ"
        value={now.delta}
        max={MOST_ROUGHNESS}
        ends={["smooth", "rough"]}
        onChange={(next) => {
          changeBend((before) => ({ ...before, delta: next }), "bend delta");
        }}
      />
      <SliderField
        label="Detail"
        symbol="ke"
        value={Math.min(now.ke, deepest)}
        max={deepest}
        step={0.1}
        words={`${formatNumber(Math.min(now.ke, deepest), 1)} scales`}
        ends={["the whole", "the smallest parts"]}
        onChange={(next) => {
          changeBend((before) => withDetail(before, next), "bend ke");
        }}
      />
      <Switch
        checked={now.spin !== "none"}
        description="Up in a part is what its map makes of up"
        onChange={(on) => changeBend((before) => ({ ...before, spin: on ? "orthogonal" : "none" }))}
      >
        Displacements turn with the pieces
      </Switch>
      {box && (
        <p class="hint">
          {box.continuous
            ? "Its pieces meet in corners: neighbours are kept together there, and nothing tears."
            : "Its pieces share no corners that could hold them together: it is bent by the formula as it stands, and tears where codes of neighbours differ."}
        </p>
      )}
    </section>
  );
}

function Chosen({ now }: { now: SpaceBend }) {
  const index = lead.value;
  const by = now.moves[index];
  if (!by) return null;
  return (
    <section class="stack" aria-label="Chosen handle">
      <div class="section-head">
        <h2>{nameOf(now.sizes, index)}, moved by</h2>
      </div>
      <div class={css["bend-numbers"]}>
        {(["x", "y", "z"] as const).map((name, axis) => (
          <NumberField
            key={name}
            label={`Moved along ${name}`}
            symbol={name}
            value={by[axis] ?? 0}
            min={-FARTHEST}
            max={FARTHEST}
            terse
            onChange={(next) => {
              const part = [0, 1, 2].map((k) => (k === axis ? next - (by[axis] ?? 0) : 0));
              changeBend(
                (before) => withMoved(before, index, [part[0] ?? 0, part[1] ?? 0, part[2] ?? 0]),
                `bend move ${name}`,
              );
            }}
            onDone={endGesture}
          />
        ))}
      </div>
      <p class="hint">
        In parts of the longest side of the lattice, along the axes of the object as it was made.
      </p>
    </section>
  );
}

function Last({ now }: { now: SpaceBend }) {
  return (
    <section class="stack" aria-label="The bend itself">
      <p class="hint">
        The maps, the shadow on a plane and a mesh for printing are those of the shape before it is bent.
        {timeline.value !== null &&
          " With a time line, where the handles are is a key of the moment; all else of the bend is so for all time."}
      </p>
      <Button kind="quiet" icon="close" disabled={now === null} onClick={() => changeBend(() => null)}>
        Not bent
      </Button>
    </section>
  );
}
