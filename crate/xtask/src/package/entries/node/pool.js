// The same for Node.
import { availableParallelism } from "node:os";
// biome-ignore lint/style/useNodejsImportProtocol: webpack breaks the other name where it takes the worker along.
import { Worker } from "worker_threads";
import { poolOf } from "../pool-lanes.js";
import { like } from "./worker-like.js";

export { FrondError } from "../guard.js";

// Without what the program was started with, such as --eval.
const spawn = () => like(new Worker(new URL("./pool-worker.js", import.meta.url), { execArgv: [] }));

export const createPool = ({ size = availableParallelism() } = {}) => poolOf(spawn, size);
