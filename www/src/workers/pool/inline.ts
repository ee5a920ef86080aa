/** Where there are no workers: slices on the page's own thread, with room for input and frames between them. */
import { loadProof } from "#wasm/proof";
import { OnPage } from "../lanes/on-page";
import { performerOf } from "../lanes/performer";
import type { Modules } from "./protocol";
import { tasks, tools } from "./tasks";

const performer = performerOf(tasks, async (_: Modules) => tools(await loadProof()));

export const onPage = () => new OnPage(performer);
