import type { InitInput, InitOutput, SyncInitInput } from "./frond.js";

export * from "./frond.js";
export { start } from "./frond.js";
export * from "./frond-curve.js";
export * from "./frond-proof.js";
export type { InitInput, InitOutput, SyncInitInput };

/** Where the three modules come from: by default, from beside this file. */
export interface Modules<Input> {
  frond: Input;
  curve: Input;
  proof: Input;
}

/** Call it once, before anything else. */
export default function init(modules?: Partial<Modules<InitInput | Promise<InitInput>>>): Promise<void>;

/** The same with what is there already. */
export function initSync(modules: Modules<SyncInitInput>): void;
