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
import { presentPhase } from "../clock";
import deformCss from "../deform.module.css";
import { isAtRest } from "../deform-edits";
import { maps, ringed } from "../facts";
import * as messages from "../messages";
import { exampleOf } from "./examples";

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

/**
 * The convex hull of points x0, y0, x1, y1, .., counter-clockwise, its sides without points between (Andrew's chain).
 */
export function hullOf(points: ArrayLike<number>): [x: number, y: number][] {
  const sorted = Array.from({ length: Math.floor(points.length / 2) }, (_, i): [number, number] => [
    points[2 * i] ?? 0,
    points[2 * i + 1] ?? 0,
  ]).sort(([x0, y0], [x1, y1]) => x0 - x1 || y0 - y1);
  const lower = chain(sorted);
  const upper = chain(sorted.reverse());
  return lower.length < 2 ? lower : [...lower.slice(0, -1), ...upper.slice(0, -1)];
}

/** The points of one side: each turns left. */
function chain(points: readonly [number, number][]): [number, number][] {
  const kept: [number, number][] = [];
  for (const p of points) {
    while (kept.length > 1 && !turnsLeft(kept.at(-2) ?? p, kept.at(-1) ?? p, p)) kept.pop();
    kept.push(p);
  }
  return kept;
}

function turnsLeft(p: readonly number[], q: readonly number[], r: readonly number[]): boolean {
  const [px = 0, py = 0] = p;
  const [qx = 0, qy = 0] = q;
  const [rx = 0, ry = 0] = r;
  return (qx - px) * (ry - py) - (qy - py) * (rx - px) > 0;
}
