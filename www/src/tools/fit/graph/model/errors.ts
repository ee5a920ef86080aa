/** How far the graph is from what is measured. */
import { computed, type ReadonlySignal } from "@preact/signals";
import { model, value } from "./document";
import { errorsOf, interval } from "./model";
import { series, sets, unmade } from "./series";

/** At the fine feature points; nothing until they are taken, and where the graph is one of another stretch of t. */
export const errors: ReadonlySignal<{ worst: number; meanSquare: number; where: number } | null> = computed(
  () => {
    const now = sets.value;
    if (!now || now.of !== series.value || unmade.value) return null;
    const [from, to] = interval(model.value.knots);
    const [first, last] = [now.fine[0] ?? 0, now.fine[now.fine.length - 2] ?? 1];
    const near = 0.01 * (last - first);
    if (Math.abs(from - first) > near || Math.abs(to - last) > near) return null;
    return errorsOf(now.fine, value.value);
  },
);
