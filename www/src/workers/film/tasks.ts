import { encodeTasks } from "./encode";
import { planeTasks } from "./plane";

/** What writes a film, and what draws frames of the plane: a worker does one or the other. */
export const tasks = { ...encodeTasks, ...planeTasks };

export type Tasks = typeof tasks;
