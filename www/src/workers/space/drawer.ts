import type { Space, SpaceView } from "#wasm/api";
import { painters } from "../film/crew";
import type { Drawer, FrameLook } from "../film/subject";
import { spaceCrew, spaceTask } from "./client";
import { Frames } from "./frames";
import type { PictureRequest } from "./picture";
import { shownObject } from "./shown";

export interface SpaceMoments {
  space: Space;
  /** From where, where no key says so. */
  view: SpaceView;
  /** From there, whatever keys say. */
  still?: boolean;
  palette: string[];
}

/** Draws moments of space, side by side. */
export function spaceDrawer(
  { width, height, smooth, ground }: FrameLook,
  alone: boolean,
  { space, view, still = false, palette }: SpaceMoments,
): Drawer {
  const crew = alone ? null : spaceCrew();
  const factor = smooth ? 2 : 1;
  const hands = alone ? 1 : painters(width * height * factor * factor);
  const frames = new Frames(space);
  let next = 0;
  let before = "";
  const request = (seconds: number): PictureRequest => {
    const frame = frames.at(seconds);
    const objects = frame.objects.map((at, i) => shownObject(at, space.objects[i]));
    const seen = still ? view : (frame.view ?? view);
    return { objects, view: seen, light: space.light, width, height, factor, palette, ground };
  };
  return {
    hands,
    get missing() {
      return frames.missing;
    },
    async frame(seconds, signal) {
      const picture = request(seconds);
      const key = JSON.stringify([picture.objects, picture.view]);
      // What stays as it was is not drawn again.
      if (key === before) return null;
      before = key;
      if (!crew) return spaceTask("measured", picture, { signal });
      return crew.task("measured", picture, { signal, lane: next++ % hands });
    },
    end() {
      crew?.end();
      frames.free();
    },
  };
}
