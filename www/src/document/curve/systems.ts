import type { Scene } from "#wasm/api";
import { edit } from "../scene";
import { standIn } from "../stand-in";

/** An edit of the systems: where something stood in their place they are back. One undo step. */
export async function editSystems(change: (scene: Scene) => Scene): Promise<void> {
  if (standIn.peek()) (await import("./back")).backToSystems(change);
  else edit(change);
}
