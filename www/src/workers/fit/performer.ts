import { startFit } from "#wasm/fit";
import { performerOf } from "../lanes/performer";
import { tasks } from "./tasks";

/** The inside of a worker of the fit. */
export const performer = performerOf(tasks, async (module) => ({ fit: await startFit(module) }));
