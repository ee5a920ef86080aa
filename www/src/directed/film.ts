/** Graph-directed shapes as frames of films. */
import { pieceColours } from "#document/colours";
import type { View } from "#geometry/coordinates";
import { directedLook } from "#stage/directed/options";
import { isDark } from "#style/ground";
import type { Colouring } from "#wasm/api";
import { directedTask } from "#workers/directed/client";
import type { Way } from "#workers/directed/moment";
import type { Drawer, FrameLook } from "#workers/film/subject";
import { isStopped } from "#workers/lanes/latest";

/** A moment of the way, and what part of the plane is seen. */
export interface DirectedFrame {
  t: number;
  view: View;
}

/** Draws a way, one frame after the other: each is complete. */
export function directedDrawer(
  { width, height, ground }: FrameLook,
  way: Way,
  colouring: Colouring,
  at: (seconds: number) => DirectedFrame,
): Drawer {
  const look = directedLook(colouring, pieceColours(isDark(ground) ? "dark" : "light"));
  let before = "";
  let missing = 0;
  return {
    hands: 1,
    get missing() {
      return missing;
    },
    async frame(seconds, signal) {
      const { t, view } = at(seconds);
      const key = JSON.stringify([t, view]);
      if (key === before) return null;
      before = key;
      const began = performance.now();
      const asked = { moment: { ...way, t }, options: { width, height, view, ...look } };
      try {
        const data = await directedTask("pixels", asked, { signal });
        return { width, height, data, took: performance.now() - began };
      } catch (problem) {
        if (isStopped(problem)) throw problem;
        // Without an attractor there is nothing to be seen.
        missing++;
        return null;
      }
    },
    end: () => {},
  };
}
