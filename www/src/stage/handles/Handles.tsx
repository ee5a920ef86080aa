/** The maps of a shape, or the whole of it, drawn over the picture to be dragged. */
import { computed } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useLayoutEffect } from "preact/hooks";
import { carryFrame, editFrame } from "#document/editing/frame";
import { placeShape, STILL, takenOf } from "#document/editing/whole";
import { type Box, boxOfTaken } from "#document/framing";
import { selection } from "#document/morph";
import { edit, inGesture, scene } from "#document/scene";
import { UNIT } from "#geometry/boxes";
import { cornersOf } from "#geometry/parallelogram";
import { restsOf } from "#geometry/snap";
import type { Shape } from "#wasm/api";
import * as messages from "../messages";
import { stageStyle } from "../picture-style";
import { stageSize } from "../view";
import { apart } from "./apart";
import { FrameGrips, frameShown } from "./frame-grips";
import { type Held, rest } from "./held";
import { Grips, middleSeen, Outline, Parallelogram, place, Resting, TAG, Tag } from "./Parallelogram";

const shape = computed<Shape | null>(() => {
  const target = selection.value?.target;
  return target ? scene.value[target] : null;
});

/** The box whose images are shown. */
const frame = (): Box => editFrame.value?.box ?? UNIT;

/** What is edited, by its handles. */
export function Handles() {
  if (!shape.value) return null;
  return selection.value?.whole ? <Whole /> : <Maps />;
}

/** The box of the whole, and what lies over it. */
function Overlay({ title, box, children }: { title: string; box: Box; children: ComponentChildren }) {
  const size = stageSize.value;
  return (
    <svg class="overlay" width={size.width} height={size.height}>
      <title>{title}</title>
      <Outline corners={cornersOf(STILL, box)} class="frame" />
      {inGesture.value && rest.value && <Resting at={place(rest.value)} />}
      {children}
    </svg>
  );
}

/** Each map is a parallelogram: the image of the box of the whole. */
function Maps() {
  const maps = shape.value?.maps;
  const chosen = selection.value;
  const focused = document.activeElement?.closest(".overlay") != null;
  useLayoutEffect(() => {
    // A map that had the focus was removed: keys go on with the one that is chosen now.
    if (focused && document.activeElement === document.body)
      (chosenBody() ?? document.querySelector<SVGElement>(".overlay [role=button]"))?.focus();
  });
  if (!maps || !chosen) return null;
  // The chosen one last, so that it lies on top.
  const order = maps.map((_, i) => i).sort((p, q) => Number(p === chosen.map) - Number(q === chosen.map));
  const { palette } = stageStyle.value;
  const colourOf = (map: number) => palette[map % palette.length] ?? "currentColor";
  const taken = chosen.map === null ? undefined : maps[chosen.map];
  const choose = (map: number) => () => {
    const now = selection.peek();
    if (now) selection.value = { ...now, map };
  };
  const tags = apart(
    maps.map((map, i) => middleSeen(heldMap(i), map)),
    2 * TAG,
  );
  return (
    <Overlay title={messages.shapesMapsAsParallelograms} box={frame()}>
      {order.map((i) => {
        const map = maps[i];
        if (!map) return null;
        return (
          <Parallelogram
            key={i}
            held={heldMap(i)}
            map={map}
            colour={colourOf(i)}
            chosen={i === chosen.map}
            choose={choose(i)}
          />
        );
      })}
      {/* Above all bodies: what is seen on top is what is taken hold of. */}
      {tags.map((at, i) => (
        <Tag key={`tag ${i + 1}`} held={heldMap(i)} mark={`${i + 1}`} at={at} choose={choose(i)} />
      ))}
      {chosen.map !== null && taken && (
        <Grips key={chosen.map} held={heldMap(chosen.map)} map={taken} colour={colourOf(chosen.map)} />
      )}
      {frameShown.value && <FrameGrips />}
    </Overlay>
  );
}

const heldMap = (index: number): Held => ({
  name: messages.mapNumber(index + 1),
  id: `${index}`,
  map: () => shape.peek()?.maps[index] ?? null,
  box: frame,
  rests: () => restsOf(shape.peek()?.maps ?? [], index, frame()),
  change(to, gesture) {
    const target = selection.peek()?.target;
    if (!target) return;
    edit(
      (before) => {
        const map = before[target].maps[index];
        if (!map) return before;
        const { maps: old } = before[target];
        const maps = carryFrame(old, old.with(index, to(map)));
        // Touched maps are no preset any more.
        return { ...before, [target]: { name: before[target].name, maps } };
      },
      { gesture },
    );
  },
});

const chosenBody = () => document.querySelector<SVGElement>(".overlay .chosen [role=button]");

/** The shape as it was taken in hand, and all that was done to it since. */
const taken = computed(() => (shape.value ? takenOf(shape.value) : null));
const takenBox = computed(() => (taken.value ? boxOfTaken(taken.value) : UNIT));

/** The whole shape: its box as it was taken, and the image of that box where it is now. */
function Whole() {
  const { moved } = taken.value ?? { moved: STILL };
  return (
    <Overlay title={messages.frameShape} box={takenBox.value}>
      <Parallelogram held={WHOLE} map={moved} colour="var(--accent)" chosen />
      <Grips held={WHOLE} map={moved} colour="var(--accent)" />
    </Overlay>
  );
}

const WHOLE: Held = {
  name: messages.fullShape,
  id: "whole",
  map: () => taken.peek()?.moved ?? null,
  box: () => takenBox.value,
  rests: () => restsOf([], 0, takenBox.peek()),
  change(to, gesture) {
    const target = selection.peek()?.target;
    const before = taken.peek();
    if (!target || !before) return;
    try {
      placeShape(target, to(before.moved), { gesture });
    } catch {
      // Drawn flat, it would be no shape: it stays as it was until the hand goes on.
    }
  },
};
