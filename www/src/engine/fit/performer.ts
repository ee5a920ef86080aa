import { toError } from "../protocol";
import { type FitModule, startFit } from "./module";
import { type Answer, type Ask, type Context, tasks } from "./tasks";

type Reply = (answer: Answer, transfer: Transferable[]) => void;
const STOPPED = { code: "stopped", message: "Something else was asked for." };
type Run = (context: Context<unknown>, args: unknown) => unknown;

/** Does what is asked, one task after the other: the inside of a worker, or the page's stand-in for one. */
export function performer(reply: Reply): (ask: Ask) => void {
  const keep = new Map<string, unknown>();
  const stopped = new Set<number>();
  const waiting = new Set<number>();
  let module: Promise<FitModule> | null = null;
  let last: Promise<void> = Promise.resolve();

  async function perform({ id, name, args }: Extract<Ask, { type: "run" }>): Promise<void> {
    if (!waiting.delete(id)) return;
    const handed: Transferable[] = [];
    const breathe = async () => {
      await new Promise((resolve) => setTimeout(resolve));
      if (stopped.has(id)) throw STOPPED;
    };
    try {
      if (!module) throw { code: "not-started", message: "The fit has not been started." };
      const fit = await module;
      await breathe();
      const context: Context<unknown> = {
        fit,
        keep,
        breathe,
        progress: (value, transfer = []) => reply({ type: "progress", id, value }, transfer),
        transfer: (...values) => handed.push(...values),
      };
      const result = await (tasks[name] as Run)(context, args);
      reply({ type: "done", id, result }, handed);
    } catch (problem) {
      // A trap leaves the instance in an unknown state.
      const fatal = problem instanceof WebAssembly.RuntimeError;
      reply({ type: "failed", id, error: toError(problem), fatal }, []);
    }
    stopped.delete(id);
  }

  return (ask) => {
    if (ask.type === "start") module = startFit(ask.module);
    else if (ask.type === "run") {
      waiting.add(ask.id);
      last = last.then(() => perform(ask));
    } else if (waiting.delete(ask.id)) {
      // Its turn had not come: the one before it goes on.
      reply({ type: "failed", id: ask.id, error: STOPPED, fatal: false }, []);
    } else stopped.add(ask.id);
  };
}
