/** Closed curves as shapes of several states: beside a system or another graph, edge by edge. */
import type { Box } from "#geometry/boxes";
import type { CurveShape, DirectedIfs, DirectedShape } from "#wasm/api";
import { loadCurves, rough } from "#wasm/curve";
import { directed, loadDirected } from "#wasm/directed";
import { withoutCurves } from "../curve/changes";
import * as messages from "../messages";
import { notify, wordsOf } from "../notice";
import { edit, scene } from "../scene";
import { openTool } from "../tool";
import { type End, oneState, withDirected } from "./changes";

/** A plant that is in one piece exactly, and so becomes any outline in one. */
const PLANT = "frond";

/** The outline, as large as what it becomes, on the same ground. */
function outlineBeside(other: DirectedIfs, { name, curve }: CurveShape): DirectedShape {
  const box = boxOf(other);
  return directed.outlineShape(name, curve, box ? [box.x0, box.y0, box.x1, box.y1] : undefined);
}

function boxOf(system: DirectedIfs): Box | null {
  try {
    const [whole] = directed.directedFacts(system).states;
    return whole ? { x0: whole.min[0], y0: whole.min[1], x1: whole.max[0], y1: whole.max[1] } : null;
  } catch {
    return null;
  }
}

/** An outline for one end of the morph, whose maps go straight, so that ends stay together. The other end stays. */
export async function chooseOutline(end: End, shape: CurveShape): Promise<boolean> {
  return told(shape, async () => {
    await loadDirected();
    const { a, b, directed: now } = scene.peek();
    const other = end === "a" ? "b" : "a";
    const beside = now ? now[other] : oneState({ a, b }[other]);
    const outline = outlineBeside(beside, shape);
    edit((before) => ({ ...withDirected(before, end, outline), mode: "linear" }));
  });
}

/**
 * A shape that is there already and an outline, edge by edge: one undo step, and the morph is opened at the end that
 * is not the outline's.
 */
export async function withOutline(end: End, shape: CurveShape, kept: DirectedShape): Promise<boolean> {
  return told(shape, async () => {
    await loadDirected();
    morphTo(end, outlineBeside(kept, shape), kept);
  });
}

/** A fern becomes this outline, or this outline a fern, from the beginning: one undo step, and the morph is opened. */
export async function fernBecomes(shape: CurveShape, end: End = "b"): Promise<boolean> {
  return told(shape, async () => {
    await loadDirected();
    const plant = directed.directedPresets().find(({ id }) => id === PLANT);
    if (!plant) throw new Error("there is no fern");
    const { id: preset, name, system } = plant;
    morphTo(end, outlineBeside(system, shape), { preset, name, ...system });
  });
}

function morphTo(end: End, outline: DirectedShape, kept: DirectedShape): void {
  const other = end === "a" ? "b" : "a";
  edit((before) => {
    const { locus: _locus, view: _view, curves: _curves, ...rest } = before;
    const ends = { a: outline, b: outline, [other]: kept };
    return { ...rest, directed: ends, mode: "linear", t: end === "b" ? 0 : 1 };
  });
  openTool("morph");
}

/** Of a shape and an outline that may fall apart on their way, the end of the outline; null for all else. */
export function plantMayHelp({ a, b }: { a: DirectedShape; b: DirectedShape }): End | null {
  if ((a.outline === undefined) === (b.outline === undefined)) return null;
  const [end, other]: [End, DirectedShape] = a.outline === undefined ? ["b", a] : ["a", b];
  return other.preset === PLANT ? null : end;
}

/** The plant that becomes any outline in one piece, in place of what stands beside an outline: one undo step. */
export async function plantInstead(): Promise<void> {
  const now = scene.peek().directed;
  const end = now && plantMayHelp(now);
  const shape = end ? now[end] : null;
  const { name, outline } = shape ?? {};
  if (!end || name === undefined || outline === undefined) return;
  await told({ name }, async () => {
    await loadCurves();
    await fernBecomes({ name, curve: rough.unpackCurve(outline) }, end);
  });
}

/** Two outlines as closed curves again, which morph with each other whatever their edges copy. */
export async function asClosedCurves(): Promise<boolean> {
  const now = scene.peek().directed;
  const [first, last] = [now?.a, now?.b];
  if (first?.outline === undefined || last?.outline === undefined) return false;
  const [p, q] = [first.outline, last.outline];
  return told({ name: first.name }, async () => {
    await loadCurves();
    const a = { name: first.name, curve: rough.unpackCurve(p) };
    const b = { name: last.name, curve: rough.unpackCurve(q) };
    edit((before) => ({ ...withoutCurves(before), curves: { a, b } }));
  });
}

/** Whether it was done; what is in the way is said. */
async function told({ name }: Pick<CurveShape, "name">, act: () => Promise<void>): Promise<boolean> {
  try {
    await act();
    return true;
  } catch (problem) {
    notify({ kind: "error", text: messages.notEdgeByEdge(name, wordsOf(problem)) });
    return false;
  }
}
