import { computed } from "@preact/signals";
import { placeShape, STILL, takenOf } from "#document/editing/whole";
import { boxOf } from "#document/framing";
import { selection } from "#document/morph";
import { scene } from "#document/scene";
import { after2, determinant } from "#geometry/maps/affine2";
import { inPlane } from "#geometry/maps/row";
import { HandPanel } from "#ui/hand/HandPanel";
import { handOn } from "#ui/hand/hold";
import { MatrixFields } from "#ui/hand/MatrixFields";
import { ParameterTable } from "#ui/hand/ParameterTable";
import type { MapRow, Shape } from "#wasm/api";
import type { End } from "../edits";
import { NumberFields } from "./MapFields";
import * as messages from "./messages";

const end = computed<End>(() => selection.value?.target ?? "a");
const shape = computed<Shape>(() => scene.value[end.value]);
const taken = computed(() => takenOf(shape.value));
const ball = computed(() => {
  const box = boxOf(shape.value.maps);
  return (
    box && {
      centre: [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2],
      radius: Math.hypot(box.x1 - box.x0, box.y1 - box.y0) / 2,
    }
  );
});

const hand = handOn<MapRow>({
  axes: ["x", "y"],
  id: () => end.value,
  identity: STILL,
  moved: computed(() => taken.value.moved),
  ball,
  ballNow: () => ball.peek(),
  transform: inPlane,
  compose: after2,
  place: (put, options) => placeShape(end.peek(), put, options),
});

/** A shape taken in hand as a whole, and what that does to its parameters. */
export function WholeShape({ target }: { target: End }) {
  const { made, moved } = taken.value;
  return (
    <>
      <p class="hint">{messages.dragShapeOnPicture}</p>
      <HandPanel
        of={hand}
        as="taken"
        matrix={
          <MatrixFields
            key={target}
            moved={moved}
            fields={(map, onChange) => <NumberFields map={map} onChange={onChange} onDone={() => {}} />}
            sizes={messages.areas}
            determinant={determinant}
            name="shape"
            place={(put) => placeShape(target, put)}
          />
        }
      />
      <ParameterTable made={made.maps} now={shape.value.maps} moved={moved} as="taken" />
    </>
  );
}
