import { toError } from "#wasm/error";
import type { Answer, Ask, Context, Table } from "./task";

type Reply = (answer: Answer, transfer: Transferable[]) => void;
type Run = (context: Context<unknown>, args: unknown) => unknown;
const STOPPED = { code: "stopped", message: "Something else was asked for." };

/** Does what is asked, one task after the other: the inside of a worker, or the page's stand-in for one. */
export type Performer = (reply: Reply) => (ask: Ask) => void;

/** `start` readies the module on this thread, and says what tasks have at hand besides their context. */
export function performerOf(tasks: Table, start: (module: WebAssembly.Module) => Promise<object>): Performer {
  return (reply) => {
    const keep = new Map<string, unknown>();
    const stopped = new Set<number>();
    const waiting = new Set<number>();
    let started: Promise<object> | null = null;
    let last: Promise<void> = Promise.resolve();

    async function perform({ id, name, args }: Extract<Ask, { type: "run" }>): Promise<void> {
      if (!waiting.delete(id)) return;
      const handed: Transferable[] = [];
      const breathe = async () => {
        await new Promise((resolve) => setTimeout(resolve));
        if (stopped.has(id)) throw STOPPED;
      };
      try {
        if (!started) throw { code: "not-started", message: "The worker has not been started." };
        const more = await started;
        await breathe();
        const context: Context<unknown> = {
          ...more,
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
      if (ask.type === "start") started = start(ask.module);
      else if (ask.type === "run") {
        waiting.add(ask.id);
        last = last.then(() => perform(ask));
      } else if (waiting.delete(ask.id)) {
        // Its turn had not come: the one before it goes on.
        reply({ type: "failed", id: ask.id, error: STOPPED, fatal: false }, []);
      } else stopped.add(ask.id);
    };
  };
}
