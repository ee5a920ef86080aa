/** The document without what nobody sees in it: what is sent to others is as short as it can be. */
import type { Scene } from "#wasm/api";

/**
 * What the open tool shows of a document, and all that it moves to. What stands in place of the two systems hides them;
 * a fit is seen in Fit alone, space in Space; and what is bent at one end of a morph does not show the other, which the
 * gallery keeps if it is its own. `plain` is what an empty link is.
 */
export function seenOf(scene: Scene, plain: Scene): Scene {
  const { fit, space, locus, ...rest } = scene;
  const { tool = "morph", curves, directed, t } = rest;
  const seen: Scene = { ...rest };
  if (fit && tool === "fit") seen.fit = fit;
  if (space && tool === "space") seen.space = space;
  if (!curves && !directed) return locus ? { ...seen, locus } : seen;
  const { a, b, mode, path, correspondence, turns } = plain;
  Object.assign(seen, { a, b, path, correspondence, turns });
  // Shapes of several states turn or are mixed number by number, as systems are.
  if (!directed) seen.mode = mode;
  if (curves && tool === "deform") {
    if (t === 0 && curves.b.preset === undefined) seen.curves = { a: curves.a, b: curves.a };
    if (t === 1 && curves.a.preset === undefined) seen.curves = { a: curves.b, b: curves.b };
  }
  return seen;
}
