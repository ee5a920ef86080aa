/** Edits that go between systems and graph-directed shapes. Each is one undo step. */
import type { DirectedShape, Shape } from "#wasm/api";
import { edit } from "../scene";
import { type End, withDirected, withSystem } from "./changes";

/** A graph-directed shape for one end of the morph; the other stays what it is. */
export function chooseDirected(end: End, shape: DirectedShape): void {
  edit((before) => withDirected(before, end, shape));
}

/** A system for one end, beside a graph-directed shape. */
export function chooseSystem(end: End, shape: Shape): void {
  edit((before) => withSystem(before, end, shape));
}
