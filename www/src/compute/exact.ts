/** What is proved of an end of the morph whose numbers mean more than their doubles say. */
import { effect, untracked } from "@preact/signals";
import "#geometry/maps/exact-gallery";
import { held, selection, shown, shownPick } from "#document/morph";
import { scene } from "#document/scene";
import { standIn } from "#document/stand-in";
import { exactOf } from "#geometry/maps/exact";
import type { Analysis, CertificateCheck, Connectedness, ExactProof, MapRow } from "#wasm/api";
import { compileExact, exactAtHand } from "#wasm/exact";
import { epoch, submit } from "#workers/pool/engine";
import { type Result, single, type Task } from "#workers/pool/protocol";
import { publish, verdict } from "./results";

/** Maps with the formulas that some of their entries mean. */
export interface Meant {
  maps: MapRow[];
  numbers: readonly string[];
}

/** The end of the morph that the stage shows; null on the way between both, and where something else is shown. */
export function endShown(): "a" | "b" | null {
  if (standIn.peek()) return null;
  const editing = selection.peek();
  if (editing) return editing.target;
  const { t, tool = "morph" } = scene.peek();
  if (tool === "space" || tool === "fit" || held.peek() || shownPick.peek()) return null;
  return t === 0 ? "a" : t === 1 ? "b" : null;
}

/** That end, where some of its numbers are no doubles. */
export function meantNow(): Meant | null {
  const end = endShown();
  if (end === null) return null;
  const shape = scene.peek()[end];
  const numbers = exactOf(shape);
  return numbers.length > 0 ? { maps: shape.maps, numbers } : null;
}

export type ExactAnswer = ExactProof & {
  check: CertificateCheck | null;
  /** The formulas that it is about. */
  numbers: readonly string[];
};

/** The request of each kind that waits for an answer: the latest alone is of interest. */
const waiting = new Map<"exact" | "analysis", () => void>();

/** Null where another request of this kind came, or the workers were lost. */
function ask<K extends "exact" | "analysis">(task: Task<K>): Promise<Result<K> | null> {
  waiting.get(task.kind)?.();
  return new Promise((resolve, reject) => {
    waiting.set(task.kind, () => resolve(null));
    submit(single<K>(task.kind, 55, task, { accept: resolve, fail: reject }));
  });
}

/** What was found last of a list of maps: the shape on the stage is judged often. */
const known = new WeakMap<MapRow[], { written: string; answer: ExactAnswer }>();

/** Asks for a proof about the numbers that are meant; null where there is none to be had. */
export async function proveMeant(epsilon: number): Promise<ExactAnswer | null> {
  const meant = meantNow();
  if (!meant) return null;
  const { maps, numbers } = meant;
  const written = `${epsilon} ${numbers.join()}`;
  const before = known.get(maps);
  if (before?.written === written) return before.answer;
  const found = await ask<"exact">({ kind: "exact", module: await compileExact(), maps, numbers, epsilon });
  if (!found) return null;
  const answer = { ...found, numbers };
  known.set(maps, { written, answer });
  return answer;
}

/** What doubles leave open may be proved of the numbers that they stand for: then the verdict says so. */
export function scheduleExact(): void {
  effect(() => {
    epoch.value;
    untracked(() => {
      for (const giveUp of waiting.values()) giveUp();
    });
  });
  effect(() => {
    const now = verdict.value;
    if (!now || now.stale || now.connectedness.verdict === "connected") return;
    untracked(() => void settle(shown.peek(), now.epsilon).catch(() => {}));
  });
}

async function settle(maps: MapRow[], epsilon: number): Promise<void> {
  const answer = exactAtHand() ? await proveMeant(epsilon) : null;
  const now = current(maps);
  if (!now) return;
  const { connectedness } = now;
  if (answer?.state !== "connected" || !answer.check?.valid) {
    if (connectedness.verdict === "touching" && !connectedness.reason) lookCloser(maps, epsilon);
    return;
  }
  publish.verdict.value = {
    ...now,
    numbers: answer.numbers,
    connectedness: {
      ...connectedness,
      verdict: "connected",
      gap: { lower: 0, upper: 0 },
      components: connectedness.components.map(() => 0),
      count: 1,
      reason: answer.reason,
    },
  };
}

/** What is said of these maps, if it is still what the stage shows. */
function current(maps: MapRow[]) {
  const now = verdict.peek();
  return now && !now.stale && shown.peek() === maps ? now : null;
}

/** So many times closer it is looked at an end of the morph that only touches: a gap may be narrower than a pixel. */
const CLOSER = 1e-3;

function lookCloser(maps: MapRow[], epsilon: number): void {
  if (endShown() === null) return;
  const accept = (connectedness: Connectedness) => {
    const now = current(maps);
    if (now && connectedness.verdict === "disconnected")
      publish.verdict.value = { ...now, connectedness, closer: task.epsilon };
  };
  const task = { kind: "verdict", maps, epsilon: CLOSER * epsilon } as const;
  submit(single<"verdict">("closer", 54, task, { accept, fail: () => {} }));
}

/** Neighbours, open set condition, dimension and boundary of the end that is shown; of doubles as they are. */
export async function analyzeShown(): Promise<Analysis | null> {
  const end = endShown();
  if (end === null) return null;
  const shape = scene.peek()[end];
  return ask<"analysis">({
    kind: "analysis",
    module: await compileExact(),
    maps: shape.maps,
    numbers: exactOf(shape),
  });
}
