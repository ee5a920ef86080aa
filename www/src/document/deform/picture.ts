import { computed, effect, type ReadonlySignal } from "@preact/signals";
import type { MapRow } from "#wasm/api";
import * as messages from "../messages";
import { notify } from "../notice";
import { tool } from "../tool";
import { deformation } from "./bend";
import { aspect, haveSample, mapsOfRectangle, ownPicture, type Photograph, photograph } from "./photograph";

export { ownPicture, type Photograph, photograph, showPicture } from "./photograph";

const subject = computed(() => deformation.value.subject);
const parts = computed(() => deformation.value.parts);

/** Whether a picture takes the place of the shape: where it is bent, and nowhere else. */
const pictureWanted = computed(() => subject.value === "picture" && tool.value === "deform");

/** What the stage draws in place of the shape: null where it draws the shape. */
export const pictureShown: ReadonlySignal<Photograph | null> = computed(() =>
  pictureWanted.value ? photograph.value : null,
);

/** The maps of the rectangle that the picture lies on. */
export const pictureMaps: ReadonlySignal<MapRow[]> = computed(() =>
  mapsOfRectangle(aspect.value, parts.value),
);

/**
 * Sees to it that there is a sample when one is wanted, and says where the picture of a link is. Returns the end of it.
 */
export function watchPicture(): () => void {
  let first = true;
  let asked = false;
  return effect(() => {
    const sampled = pictureWanted.value && !ownPicture.value;
    if (sampled && first) {
      notify({ kind: "info", text: messages.pictureNotInLink });
    }
    first = false;
    if (!sampled || asked) return;
    asked = true;
    import("./sample-picture").then(
      ({ drawSample }) => haveSample(drawSample()),
      () => {
        asked = false;
        notify({
          kind: "error",
          text: messages.sampleNotLoaded,
        });
      },
    );
  });
}
