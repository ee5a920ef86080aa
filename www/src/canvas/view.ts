import { signal } from "@preact/signals";

export interface View {
  /** World point in the middle of the stage. */
  x: number;
  y: number;
  /** CSS pixels a unit. */
  scale: number;
}

/** What part of the plane the stage shows; null fits the whole attractor. */
export const view = signal<View | null>(null);
