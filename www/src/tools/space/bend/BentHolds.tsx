import { computed, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { foldedWords } from "#geometry/folds";
import { VerdictSign } from "#ui/shapes/VerdictSign";
import type { Connectedness3, SpaceBend } from "#wasm/api";
import { isStopped } from "#workers/lanes/latest";
import { spaceTask } from "#workers/space/client";
import * as messages from "../messages";
import { made } from "../shape/now";
import css from "./bend.module.css";
import { foldedOf } from "./bend-edits";
import { bentWords } from "./holds";
import { bend, room, sidesOf, sizeOf } from "./now";

/** What was found of the shape before it is bent. */
const before = signal<{ of: string; answer: Connectedness3 | null } | null>(null);
const REST_MS = 150;

/** What is said of a lattice that is folded over. */
const folded = computed(() => {
  const [now, box] = [bend.value, room.value];
  if (!now || !box) return null;
  const size = sizeOf(box);
  const [x, y, z] = sidesOf(box);
  return foldedWords(foldedOf(now, [x / size, y / size, z / size]), messages.resetAll);
});

/** Whether the bent object is in one piece, as far as that follows from what it was before. */
export function BentHolds({ now }: { now: SpaceBend }) {
  const of = JSON.stringify(made.value);
  useEffect(() => {
    if (before.peek()?.of === of) return undefined;
    const end = new AbortController();
    const timer = setTimeout(() => {
      spaceTask("holds", { maps: JSON.parse(of) }, { signal: end.signal }).then(
        (answer) => {
          before.value = { of, answer };
        },
        (problem: unknown) => {
          if (!end.signal.aborted && !isStopped(problem)) before.value = { of, answer: null };
        },
      );
    }, REST_MS);
    return () => {
      clearTimeout(timer);
      end.abort();
    };
  }, [of]);
  const box = room.value;
  if (!box) return null;
  const known = before.value?.of === of ? before.value.answer : null;
  const { tone, text, aside, why } = bentWords(known, now, box);
  return (
    <section class="stack" aria-label={messages.inOnePiece}>
      <p class={css["bend-verdict"]} data-testid="bent-verdict">
        <VerdictSign tone={tone} />
        <strong>{text}</strong>
        {aside !== "" && <span class="dim">{aside}</span>}
      </p>
      {folded.value && <p class="hint">{folded.value}</p>}
      <details>
        <summary>{messages.why}</summary>
        <p class="hint">{why}</p>
      </details>
    </section>
  );
}
