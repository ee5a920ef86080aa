import wasmUrl from "../../pkg/frond-proof_bg.wasm?url";
import { compiled, once } from "./module";

/** What decides and proves, in a module of its own: the workers have it, and who asks for it. */
export type Proof = typeof import("../../pkg/frond-proof.js");

/** Parts of a locus, of a morph or of a polygon family. `free()` them. */
export type LocusTiles = InstanceType<Proof["LocusTiles"] | Proof["FamilyTiles"]>;

/** Fetches and compiles; the workers are given the module. */
export const compileProof = once(() => compiled(wasmUrl));

let here: Proof | null = null;

/** Has it on this thread too: where there are no workers, and for what is small enough to be done at once. */
export const loadProof = once(async (): Promise<Proof> => {
  const [bindings, module] = await Promise.all([import("../../pkg/frond-proof.js"), compileProof()]);
  await bindings.default({ module_or_path: module });
  here = bindings;
  return here;
});

/** For those who come after `loadProof`. */
export function prover(): Proof {
  if (!here) throw new Error("What decides and proves is not loaded on this thread.");
  return here;
}
