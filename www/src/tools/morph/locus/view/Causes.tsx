import "#ui/panel/fold.css";
import { computed, signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";
import { inputs } from "#compute/inputs";
import type { Field } from "#compute/locus/pyramid";
import { locusWindow } from "#compute/results";
import type { Uv } from "#geometry/path";
import { cancel, submit } from "#workers/pool/engine";
import type { Cause, Job } from "#workers/pool/protocol";
import * as messages from "../messages";
import { CLOSER, causeWords, chosen, counted, isOf, type Looked } from "./causes";
import { shownField } from "./shown";
import { epsilon, shownWindow, view } from "./view";

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
