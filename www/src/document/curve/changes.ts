/** What is done to a document that holds closed curves, as functions from scene to scene. */

import { inBox } from "#geometry/mesh";
import type { CurveShape, Deformation, Scene } from "#wasm/api";

export type End = "a" | "b";

/** Where a mesh belongs in a document; null: it stays where it is. */
type Around = (scene: Scene) => Deformation["box"] | null;
const STAYS: Around = () => null;

/**
 * A closed curve at one end. Curves morph with curves: where the document has systems, the other end becomes `partner`,
 * and the view, which was theirs, is let go. A mesh goes along with its bend.
 */
export function withCurve(
  scene: Scene,
  end: End,
  shape: CurveShape,
  partner: CurveShape,
  around: Around = STAYS,
): Scene {
  const other = scene.curves ? scene.curves[end === "a" ? "b" : "a"] : partner;
  const curves = end === "a" ? { a: shape, b: other } : { a: other, b: shape };
  if (scene.curves) return meshed({ ...scene, curves }, around);
  const { view: _, directed: __, ...rest } = scene;
  return meshed({ ...rest, curves }, around);
}

/** The document with its systems again; the same where nothing stands in their place. */
export function withoutCurves(scene: Scene, around: Around = STAYS): Scene {
  if (!scene.curves && !scene.directed) return scene;
  const { curves: _, directed: __, view: ___, ...rest } = scene;
  return meshed(rest, around);
}

/** The same morph, run from the other side. */
export function swapCurves(scene: Scene): Scene {
  if (!scene.curves) return scene;
  return { ...scene, curves: { a: scene.curves.b, b: scene.curves.a }, t: 1 - scene.t };
}

/** The curve of one end at both. */
export function curveAtBoth(scene: Scene, end: End): Scene {
  if (!scene.curves) return scene;
  const shape = scene.curves[end];
  return { ...scene, curves: { a: shape, b: shape } };
}

function meshed(scene: Scene, around: Around): Scene {
  // A picture that is bent has a place of its own.
  if (!scene.deform || scene.deform.subject === "picture") return scene;
  const box = around(scene);
  return box ? { ...scene, deform: inBox(scene.deform, box) } : scene;
}

/** Whether both ends are the same: then there is no morph to speak of. */
export function sameCurves({ a, b }: NonNullable<Scene["curves"]>): boolean {
  return a.curve === b.curve || JSON.stringify(a.curve) === JSON.stringify(b.curve);
}
