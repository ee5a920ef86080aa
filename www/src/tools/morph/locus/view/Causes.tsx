import "#ui/panel/fold.css";
import { computed, signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";
import { inputs } from "#compute/inputs";
import type { Field } from "#compute/locus/pyramid";
import { locusWindow } from "#compute/results";
import { resolutionWords } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { STATE } from "#geometry/states";
import type { Bounds } from "#wasm/api";
import { cancel, submit } from "#workers/pool/engine";
import type { Cause, Job } from "#workers/pool/protocol";
import * as messages from "../messages";
import { epsilon, shownField, shownWindow, view } from "./view";

// Why samples of the map only look whole: some of them are looked at closer.

/** So many times closer. */
export const CLOSER = 1e-3;
/** Samples that are looked at: enough to tell what is common from what is rare. */
const MOST = 48;

interface Sampled {
  width: number;
  height: number;
  state: ArrayLike<number>;
  bounds: Bounds;
}

/** What was found of a map, and of which one. */
export interface Looked {
  causes: Cause[];
  of: number;
  /** The morph, as one value. */
  inputs: object;
  /** The part of its map, and how near pieces count as touching. */
  where: string;
}

/** The same of the map that is shown now; null of any other. */
export const isOf = (found: Looked | null, inputs: object, where: string): Looked | null =>
  found?.inputs === inputs && found.where === where ? found : null;

/** Samples that only look whole, evenly chosen from all of them. */
export function chosen({ width, height, state, bounds: { u0, v0, u1, v1 } }: Sampled): Uv[] {
  const all: number[] = [];
  for (let i = 0; i < width * height; i++) if (state[i] === STATE.touching) all.push(i);
  const count = Math.min(MOST, all.length);
  const at = (low: number, high: number, k: number, of: number) =>
    low + ((high - low) * k) / Math.max(1, of - 1);
  return Array.from({ length: count }, (_, k) => {
    const i = all[Math.floor(((k + 0.5) * all.length) / count)] ?? 0;
    return [at(u0, u1, i % width, width), at(v0, v1, Math.floor(i / width), height)];
  });
}

/** Each cause with its count, the most common first. */
export function counted(causes: readonly Cause[]): [cause: Cause, count: number][] {
  const counts = new Map<Cause, number>();
  for (const cause of causes) counts.set(cause, (counts.get(cause) ?? 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1]);
}

/** A cause in words, where pieces within `epsilon` of the diameter counted as touching. */
export function causeWords(cause: Cause, epsilon: number): string {
  switch (cause) {
    case "apart":
      return messages.narrowerGap(resolutionWords(epsilon));
    case "search":
      return messages.inOnePieceLonger;
    case "rounding":
      return messages.sharingPointsIfDecimals;
    case "near":
      return messages.stillNoGap(resolutionWords(CLOSER * epsilon));
    case "open":
      return messages.stillOpen(resolutionWords(CLOSER * epsilon));
  }
}

/** Samples looked at in one slice, and milliseconds for which the map has to be still before. */
const AT_ONCE = 2;
const STILL = 1500;

const found = signal<Looked | null>(null);

const where = computed(() => {
  const { u0, v0, u1, v1 } = shownWindow.value;
  return [u0, v0, u1, v1, view.value.w, epsilon.value].join(" ");
});

/** Why samples of the map only look whole. */
export function Causes() {
  const [open, setOpen] = useState(false);
  const whole = locusWindow.value?.progress === 1;
  useLook(open && whole ? shownField.value : null);
  const now = isOf(found.value, inputs.value, where.value);
  return (
    <details class="fold" open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{messages.whySomeNotProved}</summary>
      {open && (
        <div class="fold-body" aria-live="polite">
          {now === null || now.causes.length === 0 ? (
            <p class="hint">{now?.of === 0 ? messages.allPaleAreaProved : messages.checkingMoreClosely}</p>
          ) : (
            <>
              <p class="hint">
                {now.causes.length < now.of
                  ? messages.checkingCauses(now.causes.length, now.of)
                  : messages.causesOf(now.of)}
              </p>
              <ul class="hint">
                {counted(now.causes).map(([cause, count]) => (
                  <li key={cause}>
                    <span class="number">{count}</span> {causeWords(cause, epsilon.value)}
                  </li>
                ))}
              </ul>
            </>
          )}
        </div>
      )}
    </details>
  );
}

/** Looks at a field once nothing has changed for a moment. */
function useLook(field: Field | null): void {
  useEffect(() => {
    if (!field) return;
    const wait = setTimeout(() => look(field), STILL);
    return () => clearTimeout(wait);
  }, [field]);
  useEffect(() => () => cancel("causes"), []);
}

/** Looks at some of them closer, in place of what was looked at before. */
function look(field: Field): void {
  const { from, to, options } = inputs.peek();
  const { w } = view.peek();
  const points = chosen(field).map(([u, v]): Uv => (w === 0 ? [u, v] : [u, v, w]));
  const looked: Looked = { causes: [], of: points.length, inputs: inputs.peek(), where: where.peek() };
  found.value = looked;
  const closer = { ...options, epsilon: CLOSER * epsilon.peek() };
  const job: Job<"causes"> = {
    channel: "causes",
    // After the proofs: what these settle is no cause.
    priority: () => 0,
    next() {
      const some = points.splice(0, AT_ONCE);
      return some.length > 0 ? { kind: "causes", from, to, options: closer, points: some } : null;
    },
    accept(_, causes) {
      found.value = { ...looked, causes: [...(found.peek()?.causes ?? []), ...causes] };
    },
    fail(task) {
      const causes = task.points.map((): Cause => "open");
      found.value = { ...looked, causes: [...(found.peek()?.causes ?? []), ...causes] };
    },
  };
  submit(job);
}
