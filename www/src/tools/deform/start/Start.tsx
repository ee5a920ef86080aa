import { computed } from "@preact/signals";
import { curveMorph } from "#document/curve/curve";
import {
  aroundStanding,
  changeDeformation,
  deformation,
  ON_CURVES,
  phasePlaying,
} from "#document/deform/bend";
import { announce } from "#document/notice";
import { edit, scene } from "#document/scene";
import { sizeOf } from "#geometry/mesh";
import { Button } from "#ui/controls/Button";
import { frond } from "#wasm/core";
import { isAtRest } from "../changes";
import { presentPhase } from "../clock";
import deformCss from "../deform.module.css";
import { maps, ringed } from "../facts";
import * as messages from "../messages";
import { exampleOf } from "./examples";
import { hullOf } from "./hull";

const rests = computed(() => isAtRest(deformation.value));

/** Where to begin, until something is bent. */
export function Start() {
  if (!rests.value) return null;
  return (
    <div class={deformCss["start"]}>
      <p>
        <strong>{messages.dragPointGrid}</strong> {messages.everyPartAtEvery}
      </p>
      <Button kind="primary" onClick={showMe}>
        {messages.showMe}
      </Button>
    </div>
  );
}

/** Back to where one began. */
export function StartOver() {
  return (
    <Button kind="quiet" icon="reset" disabled={rests.value} onClick={startOver}>
      {messages.startOver}
    </Button>
  );
}

/** A bend that shows best on the shape that is there. */
function showMe(): void {
  const { t, a, curves } = scene.peek();
  const { subject } = deformation.peek();
  const shape = subject === "shape" && t === 0 ? (curves?.a ?? a) : {};
  const curve = ringed.peek() ? curveMorph.peek() : null;
  const bounds = curve
    ? { hull: hullOf(curve.polyline(t, { tolerance: 1e-3 * sizeOf(aroundStanding.peek()) })) }
    : frond.bounds({ maps: maps.peek() });
  const example = exampleOf(deformation.peek(), shape, bounds);
  changeDeformation(() => ({ ...example.deformation, ...(curve ? ON_CURVES : {}) }));
  announce(example.words);
  if (example.moves) presentPhase();
}

function startOver(): void {
  phasePlaying.value = false;
  edit(({ deform, ...rest }) => {
    // A picture stays what is bent; a shape needs nothing that says so.
    if (deform?.subject !== "picture") return rest;
    const moves = new Array<number>(2 * deform.columns * deform.rows).fill(0);
    return { ...rest, deform: { ...deform, keys: [{ at: 0, moves }], phase: 0 } };
  });
  announce(messages.gridAtRest);
}
