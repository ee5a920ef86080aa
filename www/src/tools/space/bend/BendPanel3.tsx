import { endGesture } from "#document/scene";
import { changeSpace } from "#document/space/edits";
import { chosen, spaceReady, timeline } from "#document/space/space";
import { formatNumber } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { SliderField } from "#ui/controls/SliderField";
import { Switch } from "#ui/controls/Switch";
import type { SpaceBend } from "#wasm/api";
import * as messages from "../messages";
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
} from "./bend-edits";
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
  const name = object.value?.name ?? messages.object;
  return (
    <section class="stack" aria-label={messages.startToDeform}>
      <p class="hint">{messages.latticeAround(name)}</p>
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
        {messages.deform}
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
    <section class="stack" aria-label={messages.lattice}>
      <div class="section-head">
        <h2>{messages.lattice}</h2>
        <Button
          kind="quiet"
          icon="reset"
          disabled={isAtRest(now)}
          onClick={() => changeBend((before) => ({ ...before, moves: before.moves.map(() => [0, 0, 0]) }))}
        >
          {messages.resetAll}
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
      <p class="row-name">{messages.handlesAlongEachAxis}</p>
      <div class={css["bend-numbers"]}>
        {(["x", "y", "z"] as const).map((name, axis) => (
          <NumberField
            key={name}
            label={messages.handlesAlong(name)}
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
    <section class="stack" aria-label={messages.howPartsRespond}>
      <div class="section-head">
        <h2>{messages.howPartsRespond}</h2>
      </div>
      <SliderField
        label={messages.locality}
        symbol={messages.kb}
        value={now.kb}
        max={now.ke}
        step={0.1}
        words={
          now.kb >= now.ke ? "plain" : messages.localityOf(formatNumber(now.kb, 1), formatNumber(now.ke, 1))
        }
        ends={[messages.scatteredEveryPartResponds, "plain"]}
        onChange={(next) => {
          changeBend((before) => withLocality(before, next), "bend kb");
        }}
      />
      <SliderField
        label={messages.roughness}
        symbol={messages.text}
        value={now.delta}
        max={MOST_ROUGHNESS}
        ends={["smooth", "rough"]}
        onChange={(next) => {
          changeBend((before) => ({ ...before, delta: next }), "bend delta");
        }}
      />
      <SliderField
        label={messages.detail}
        symbol={messages.ke}
        value={Math.min(now.ke, deepest)}
        max={deepest}
        step={0.1}
        words={messages.scales(formatNumber(Math.min(now.ke, deepest), 1))}
        ends={[messages.fullShape, messages.smallestParts]}
        onChange={(next) => {
          changeBend((before) => withDetail(before, next), "bend ke");
        }}
      />
      <Switch
        checked={now.spin !== "none"}
        description={messages.upInPartWhat}
        onChange={(on) => changeBend((before) => ({ ...before, spin: on ? "orthogonal" : "none" }))}
      >
        {messages.displacementsRotateWithPieces}
      </Switch>
      {box && (
        <p class="hint">{box.continuous ? messages.piecesMeetInCorners : messages.piecesShareNoCorners}</p>
      )}
    </section>
  );
}

function Chosen({ now }: { now: SpaceBend }) {
  const index = lead.value;
  const by = now.moves[index];
  if (!by) return null;
  return (
    <section class="stack" aria-label={messages.selectedHandle}>
      <div class="section-head">
        <h2>{messages.movedBy(nameOf(now.sizes, index))}</h2>
      </div>
      <div class={css["bend-numbers"]}>
        {(["x", "y", "z"] as const).map((name, axis) => (
          <NumberField
            key={name}
            label={messages.movedAlong(name)}
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
      <p class="hint">{messages.inFractionsLongestSide}</p>
    </section>
  );
}

function Last({ now }: { now: SpaceBend }) {
  return (
    <section class="stack" aria-label={messages.deformation}>
      <p class="hint">{timeline.value === null ? messages.undeformed : messages.undeformedKeyed}</p>
      <Button kind="quiet" icon="close" disabled={now === null} onClick={() => changeBend(() => null)}>
        {messages.removeDeformation}
      </Button>
    </section>
  );
}
