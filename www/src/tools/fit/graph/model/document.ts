/** The graph of the document, what it is made of, and what hands do to it. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { changeFit, fitDocument } from "#document/fit";
import { announce, notify, wordsOf } from "#document/notice";
import type { Graph } from "#wasm/api";
import { rough } from "#wasm/curve";
import { fromGraph, toWord } from "../../plane/model/curve";
import * as messages from "../messages";
import { asKind, evaluator, type Kind, type Model, modelOf, request, short } from "./model";

/** Where nothing was made yet: Figure 1 of the paper. */
export const FIRST: Graph = {
  kind: "fif",
  pieces: [
    { map: [0.5, 1, 0.6, 0, 0], domain: [0, 1] },
    { map: [0.5, -1, 0.4, 0.5, 1], domain: [0, 1] },
  ],
};

export const graph: ReadonlySignal<Graph> = computed(() => fitDocument.value.graph ?? FIRST);

/** Whether the document has a graph of its own. */
export const isFirst: ReadonlySignal<boolean> = computed(() => fitDocument.value.graph === undefined);

/** The graph at any t, on this thread and at once. */
export const value: ReadonlySignal<(t: number) => number> = computed(() => evaluator(graph.value));

/** Made by hand from a model: the model says what was meant, to the last digit. */
const meant = new WeakMap<Graph, Model>();

export const model: ReadonlySignal<Model> = computed(() => {
  const now = graph.value;
  return meant.get(now) ?? modelOf(now, value.value);
});

/** The piece or knot that is looked at. */
export const chosenPiece = signal(0);
export const chosenKnot = signal<number | null>(null);

/** What stood in the way of the last change; null once one was made. */
export const problem = signal<string | null>(null);

/** Changes what the graph is made of: one undo step, or part of a gesture. Says whether it could. */
export function changeModel(change: (now: Model) => Model, gesture?: string): boolean {
  const before = model.peek();
  const after = change(before);
  if (after === before) return true;
  const { points, options } = request(after);
  try {
    const next = short(rough.interpolation(points, options));
    meant.set(next, after);
    take(next, gesture);
    return true;
  } catch (wrong) {
    problem.value = wordsOf(wrong);
    return false;
  }
}

/** Another graph altogether. */
export function take(next: Graph, gesture?: string): void {
  changeFit((fit) => ({ ...fit, mode: "graph", graph: next }), gesture === undefined ? {} : { gesture });
  problem.value = null;
  const pieces = next.pieces.length;
  if (chosenPiece.peek() >= pieces) chosenPiece.value = pieces - 1;
  const knot = chosenKnot.peek();
  if (knot !== null && knot > pieces) chosenKnot.value = null;
}

const NAMES: Record<Kind, string> = {
  fif: messages.everyPieceCopiesWhole,
  rfif: messages.everyPieceCopiesStretch,
  pfif: messages.everyPieceCopiesAny,
};

/** The most pieces that parts are cut into so that all of them end at points. */
const MOST_CUT = 128;

export function chooseKind(kind: Kind): void {
  const now = model.peek();
  if (now.kind === kind) return;
  if (kind === "rfif" && now.kind === "pfif") {
    // Cut finer where that makes it the very same function.
    const same = rough.toRecurrent(graph.peek(), MOST_CUT);
    if (same) {
      take(short({ ...same, kind: "rfif" }));
      announce(messages.sameInPieces(same.pieces.length));
      return;
    }
    notify({
      kind: "info",
      text: messages.thesePiecesCannotCut,
    });
  }
  if (changeModel((model_) => asKind(model_, kind))) announce(NAMES[kind]);
}

/** The same graph as a curve of the plane, cut finer where parts end between points. */
export function asPlaneCurve(): void {
  const now = graph.peek();
  const cut = now.kind === "pfif" ? rough.toRecurrent(now, MOST_CUT) : now;
  const plane = cut && fromGraph(cut, evaluator(cut));
  if (plane) {
    changeFit((fit) => ({ ...fit, mode: "plane", plane: toWord(plane) }));
    announce(messages.planeCurveOf(plane.pieces.length));
  } else {
    notify({
      kind: "info",
      text: messages.thesePiecesCannotCutSo,
    });
  }
}

export interface Facts {
  contractivity: number;
  dimension: number | null;
  counted: boolean;
  widestGap: number;
  continuous: boolean;
  integral: number | null;
}

export const facts: ReadonlySignal<Facts | null> = computed(() => {
  try {
    return rough.graphFacts(graph.value);
  } catch {
    return null;
  }
});
