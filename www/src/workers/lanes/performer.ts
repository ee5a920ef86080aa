import { toError } from "#wasm/error";
import type { Answer, Ask, Context, Table } from "./task";

type Reply = (answer: Answer, transfer: Transferable[]) => void;
type Run = (context: Context<unknown>, args: unknown) => unknown;
const STOPPED = { code: "stopped", message: "Something else was asked for." };

/** Does what is asked: the inside of a worker, or the page's stand-in for one. Its lane gives it one task at a time. */
export type Performer<M = WebAssembly.Module> = (reply: Reply) => (ask: Ask<M>) => void;

/**
 * `start` readies the module on this thread, and says what tasks have at hand besides their context. A task that is
 * called off at once is not begun: for that it waits a turn, which takes some milliseconds. With `atOnce` it does not.
 */
export function performerOf<M = WebAssembly.Module>(
  tasks: Table,
  start: (module: M) => Promise<object>,
  atOnce = false,
): Performer<M> {
  return (reply) => {
    const keep = new Map<string, unknown>();
    let more: object = {};
    /** The task under way, until it is to stop. */
    let wanted: number | null = null;

    async function perform({ id, name, args }: Extract<Ask<M>, { type: "run" }>): Promise<void> {
      wanted = id;
      const handed: Transferable[] = [];
      const breathe = async () => {
        await new Promise((resolve) => setTimeout(resolve));
        if (wanted !== id) throw STOPPED;
      };
      try {
        if (!atOnce) await breathe();
        const started = performance.now();
        const context: Context<unknown> = {
          ...more,
          keep,
          breathe,
          progress: (value, transfer = []) => reply({ type: "progress", id, value }, transfer),
          transfer: (...values) => handed.push(...values),
        };
        const result = await (tasks[name] as Run)(context, args);
        reply({ type: "done", id, result, milliseconds: performance.now() - started }, handed);
      } catch (problem) {
        // A trap leaves the instance in an unknown state.
        const fatal = problem instanceof WebAssembly.RuntimeError;
        reply({ type: "failed", id, error: toError(problem), fatal }, []);
      }
    }

    async function ready(module: M): Promise<void> {
      try {
        more = await start(module);
        reply({ type: "ready" }, []);
      } catch (problem) {
        reply({ type: "unable", error: toError(problem) }, []);
      }
    }

    return (ask) => {
      if (ask.type === "start") void ready(ask.module);
      else if (ask.type === "run") void perform(ask);
      else if (wanted === ask.id) wanted = null;
    };
  };
}
