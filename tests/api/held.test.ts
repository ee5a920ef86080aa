/** The stage while a waypoint is moved: by the module that says how far a shape reaches. */
import { readFile } from "node:fs/promises";
import { beforeAll, expect, it } from "vitest";
import { boxOf } from "#document/framing";
import { hold, shown } from "#document/morph";
import { edit, endGesture, scene } from "#document/scene";
import { effectiveView, FOOT, followFit, stageSize } from "#stage/view";
import initCore from "../../www/pkg/frond-first.js";

const SIDE = 600;

beforeAll(async () => {
  await initCore({ module_or_path: readFile(new URL("../../www/pkg/frond-first_bg.wasm", import.meta.url)) });
  stageSize.value = { width: SIDE, height: SIDE };
  // Every movement is done at once.
  followFit((tick) => {
    for (let now = 0; tick(now); now += 100);
    return () => {};
  });
});

/** Moves the first waypoint, as a hand does. */
function move(u: number, v: number): void {
  edit((before) => ({ ...before, path: { kind: "drawn", points: [[u, v]] } }), { gesture: "way-drag-0" });
  hold([u, v]);
}

/** Whether all of the shape is on the stage, above what is written at its foot. */
function isSeen(): boolean {
  const box = boxOf(shown.value);
  if (!box) throw new Error("no shape");
  const { x, y, scale } = effectiveView.value;
  const far = [box.x1 - x, x - box.x0, box.y1 - y, y - box.y0 + FOOT / scale];
  return Math.max(...far) * scale < SIDE / 2;
}

it("shows all of the shape at a waypoint that is moved, however large it is there", () => {
  move(0.5, 0.5);
  const before = effectiveView.value.scale;
  expect(isSeen()).toBe(true);
  move(1.2, 1.9);
  expect(isSeen()).toBe(true);
  expect(effectiveView.value.scale).toBeLessThan(before);
  endGesture();
  expect(scene.value.path.points).toEqual([[1.2, 1.9]]);
  expect(isSeen()).toBe(true);
});
