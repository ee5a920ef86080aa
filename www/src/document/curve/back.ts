import type { Scene } from "#wasm/api";
import { boxAround } from "../framing";
import { edit } from "../scene";
import { withoutCurves } from "./changes";

/** The systems that were there before, after a change of theirs if there is one. One undo step. */
export function backToSystems(change: (scene: Scene) => Scene = (now) => now): void {
  edit((before) => withoutCurves(change(before), ({ a }) => boxAround(a.maps)));
}
