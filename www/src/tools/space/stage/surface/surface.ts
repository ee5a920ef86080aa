import type { PainterBackend } from "#stage/surface/painter";
import type { Pixels } from "#stage/surface/surface";
import type { SpaceLight, SpaceView } from "#wasm/api";
import type { SpaceLook } from "#wasm/space";
import type { Sight } from "../sight";

/** One picture of space, in device pixels. */
export interface Wanted extends SpaceLook {
  sight: Sight;
  view: SpaceView;
  light: SpaceLight;
}

/** What the complete picture turned out to be. */
export interface Completed {
  /** Not a pixel is lit. */
  empty: boolean;
}

/** Something that fills a canvas with a picture of space. */
export interface Surface {
  readonly canvas: HTMLCanvasElement;
  readonly backend: PainterBackend;
  /** Whether what was completed for one picture will do for another. */
  keeps(before: Wanted, after: Wanted): boolean;
  /**
   * Shows what can be shown at once, in a frame that came so many ms after it was asked for. Throws where there is no
   * such view.
   */
  draw(wanted: Wanted, waited: number): { points: number };
  /**
   * Makes the complete picture of what was drawn last, and shows it: first one pixel for each, then smoothed. Rejected
   * where it is called off.
   */
  complete(wanted: Wanted, signal: AbortSignal, onShown: (completed: Completed) => void): Promise<void>;
  /** The object at a place from 0 to 1 across and down, as far as the picture that is shown tells. */
  objectAt(x: number, y: number): number | null;
  pixels(): Promise<Pixels>;
  /** Gives its device up, as a browser may take it. */
  forceLoss(): void;
  free(): void;
}

/** Whether both are of the same things, from the same place, in the same size. */
export function sameView(a: Wanted, b: Wanted): boolean {
  return (
    a.sight === b.sight &&
    a.width === b.width &&
    a.height === b.height &&
    a.factor === b.factor &&
    (a.view === b.view || JSON.stringify(a.view) === JSON.stringify(b.view))
  );
}

/** Whether both have the same light and colours. */
export function sameLight(a: Wanted, b: Wanted): boolean {
  return (
    a.ground === b.ground &&
    (a.light === b.light || JSON.stringify(a.light) === JSON.stringify(b.light)) &&
    JSON.stringify(a.palette) === JSON.stringify(b.palette)
  );
}

/** As much of it as uniforms are made of. */
export function lookOf({ width, height, factor, palette, ground }: Wanted): SpaceLook {
  return { width, height, factor, palette, ground };
}
