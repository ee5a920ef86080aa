/** What stands in place of the two systems of a document: closed curves, or graph-directed shapes. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { Box } from "#geometry/boxes";
import type { Scene } from "#wasm/api";
import { scene } from "./scene";

/** Which of these, if any. */
export const standIn: ReadonlySignal<"curves" | "directed" | null> = computed(() => {
  const { curves, directed } = scene.value;
  return curves ? "curves" : directed ? "directed" : null;
});

/** The two ends of a document, whatever they are. */
export const endsOf = ({ a, b, curves, directed }: Scene): Record<"a" | "b", { name: string }> =>
  curves ?? directed ?? { a, b };

/** What is said of closed curves, whatever becomes of them. */
export const CURVES = "one closed curve";

/** The box of graph-directed shapes at any moment, once there is what knows it. */
export const directedBoxAt = signal<((t: number) => Box | null) | null>(null);

/** What is said at the present moment of what stands there: of closed curves always the same. */
export const standInWords = signal(CURVES);
