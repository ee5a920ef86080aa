/** The map that is looked at, as it copies the feature points (Fig 5, middle). */
import { computed, type ReadonlySignal } from "@preact/signals";
import { chosen, copying, current, found, mapOf, picks, search } from "../find/search";
import type { Copy } from "./paint";

export const copyShown: ReadonlySignal<Copy | null> = computed(() => {
  const now = search.value;
  const index = chosen.value;
  const cluster = index === null ? undefined : found.value[index];
  if (!now || !cluster || !copying.value || !current.value) return null;
  const { fine } = now.sets;
  const all: [number, number] = [fine[0] ?? 0, fine[fine.length - 2] ?? 1];
  const picked = picks.value.find((pick) => pick.cluster === index);
  const [alpha, beta] = picked?.domain ?? cluster.candidate?.domain ?? all;
  const [a, b, c, d, e] = picked?.map ?? mapOf(cluster);
  const from: number[] = [];
  const to: number[] = [];
  const near = 1e-9 * (all[1] - all[0]);
  for (let i = 0; i + 1 < fine.length; i += 2) {
    const [t, x] = [fine[i] ?? 0, fine[i + 1] ?? 0];
    if (t < alpha - near || t > beta + near) continue;
    from.push(t, x);
    to.push(a * t + d, b * t + c * x + e);
  }
  return from.length === 0 ? null : { from: Float64Array.from(from), to: Float64Array.from(to) };
});
