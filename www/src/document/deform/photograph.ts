import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { MapRow } from "#wasm/api";

/** A picture that can be bent: straight alpha, row 0 on top. It never leaves the page. */
export interface Photograph {
  readonly pixels: Uint8ClampedArray<ArrayBuffer>;
  readonly width: number;
  readonly height: number;
  readonly name: string;
}

/** The size of the sample, in pixels: it is known before it is drawn. */
export const SAMPLE = { width: 1440, height: 1080 } as const;

const chosen = signal<Photograph | null>(null);
const sample = signal<Photograph | null>(null);

/** What was chosen last, or else the sample, once it is drawn. */
export const photograph: ReadonlySignal<Photograph | null> = computed(() => chosen.value ?? sample.value);

/** Whether it is one that the user chose. */
export const ownPicture: ReadonlySignal<boolean> = computed(() => chosen.value !== null);

/** Width over height: at rest it lies on [0, aspect] x [0, 1]. */
export const aspect: ReadonlySignal<number> = computed(() => {
  const { width, height } = chosen.value ?? SAMPLE;
  return width / height;
});

/** Shows another picture; null goes back to the sample. */
export function showPicture(next: Photograph | null): void {
  chosen.value = next;
}

/** The sample has been drawn. */
export function haveSample(drawn: Photograph): void {
  sample.value = drawn;
}

/** `parts` x `parts` copies of [0, aspect] x [0, 1] that fill it: x first, from the lower left, as letters count. */
export function mapsOfRectangle(aspect: number, parts: number): MapRow[] {
  const s = 1 / parts;
  return Array.from({ length: parts * parts }, (_, i): MapRow => {
    const x = i % parts;
    return [s, 0, 0, s, (x * aspect) / parts, (i - x) / parts / parts];
  });
}
