import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import type { MapRow } from "../engine/api";
import { deformation, tool } from "./bend";
import { notify } from "./notice";

/** A picture that can be bent: straight alpha, row 0 on top. It never leaves the page. */
export interface Photograph {
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
  readonly width: number;
  readonly height: number;
  readonly name: string;
}

const chosen = signal<Photograph | null>(null);
const sample = signal<Photograph | null>(null);

/** What was chosen last, or else the sample, once it is drawn. */
export const photograph: ReadonlySignal<Photograph | null> = computed(() => chosen.value ?? sample.value);

/** Whether it is one that the user chose. */
export const ownPicture: ReadonlySignal<boolean> = computed(() => chosen.value !== null);

/** Whether the document is about a picture, and it is to be seen. */
const wanted = computed(() => {
  const { subject, on } = deformation.value;
  return subject === "picture" && (on || tool.value === "deform");
});

/** What the stage draws in place of the shape: null where it draws the shape. */
export const pictureShown: ReadonlySignal<Photograph | null> = computed(() =>
  wanted.value ? photograph.value : null,
);

/** Width over height of what is shown, 1 where there is nothing yet. At rest it lies on [0, aspect] x [0, 1]. */
export const aspect: ReadonlySignal<number> = computed(() => {
  const shown = photograph.value;
  return shown ? shown.width / shown.height : 1;
});

/** The maps of the rectangle that the picture lies on: their order is that of the letters, x first, from the lower left. */
export const pictureMaps: ReadonlySignal<MapRow[]> = computed(() =>
  mapsOfRectangle(aspect.value, deformation.value.parts),
);

/** `parts` x `parts` copies of [0, aspect] x [0, 1] that fill it. */
export function mapsOfRectangle(aspect: number, parts: number): MapRow[] {
  const s = 1 / parts;
  return Array.from({ length: parts * parts }, (_, i): MapRow => {
    const x = i % parts;
    return [s, 0, 0, s, (x * aspect) / parts, (i - x) / parts / parts];
  });
}

/** Shows another picture; null goes back to the sample. */
export function showPicture(next: Photograph | null): void {
  chosen.value = next;
}

/** Sees to it that there is a sample when one is wanted, and says where the picture of a link is. Returns the end of it. */
export function watchPicture(): () => void {
  let first = true;
  let asked = false;
  return effect(() => {
    const now = wanted.value && !chosen.value;
    if (now && first) {
      notify({ kind: "info", text: "The picture itself is not in the link: choose it again." });
    }
    first = false;
    if (!now || asked) return;
    asked = true;
    import("../views/deform/picture/sample").then(
      ({ drawSample }) => {
        sample.value = drawSample();
      },
      () => {
        asked = false;
        notify({
          kind: "error",
          text: "The sample picture could not be loaded. Choose a picture of your own.",
        });
      },
    );
  });
}
