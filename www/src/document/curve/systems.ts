import type { Scene } from "#wasm/api";
import { edit } from "../scene";
import { curved } from "./curve";

/** An edit of the systems: where curves stood in their place they are back. One undo step. */
export async function editSystems(change: (scene: Scene) => Scene): Promise<void> {
  if (curved.peek()) (await import("./edits")).backToSystems(change);
  else edit(change);
}
