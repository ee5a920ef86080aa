import { toError } from "#wasm/error";
import type { Answer, Ask, Context, Table } from "./task";

type Reply = (answer: Answer, transfer: Transferable[]) => void;
type Run = Extract<Ask, { type: "run" }>;
type Perform = (context: Context<unknown>, args: unknown) => unknown;
const STOPPED = { code: "stopped", message: "Something else was asked for." };

/**
 * Does what is asked, one task after the other: the inside of a worker, or the page's stand-in for one. A task that is
 * called off before its turn is not begun.
 */
export type Performer<M = WebAssembly.Module> = (reply: Reply) => (ask: Ask<M>) => void;

/**
 * `start` readies the module on this thread, and says what tasks have at hand besides their context. Before each task
 * it waits a turn, in which it hears what is called off: some milliseconds, or, with `atOnce`, hardly any.
 */
export function performerOf<M = WebAssembly.Module>(
  tasks: Table,
  start: (module: M) => Promise<object>,
  atOnce = false,
): Performer<M> {
  return (reply) => {
    const keep = new Map<string, unknown>();
    let more: object = {};
    /** What was asked for, in the order that it came, until it has ended or is called off. */
    const wanted = new Map<number, Run>();
    /** The task under way. */
    let current: number | null = null;
    let performing = false;
    const turn = atOnce ? quickTurns() : slowTurn;

    async function perform({ id, name, args }: Run): Promise<void> {
      const handed: Transferable[] = [];
      const breathe = async () => {
        await slowTurn();
        if (!wanted.has(id)) throw STOPPED;
      };
      try {
        const started = performance.now();
        const context: Context<unknown> = {
          ...more,
          keep,
          breathe,
          progress: (value, transfer = []) => reply({ type: "progress", id, value }, transfer),
          transfer: (...values) => handed.push(...values),
        };
        const result = await (tasks[name] as Perform)(context, args);
        reply({ type: "done", id, result, milliseconds: performance.now() - started }, handed);
      } catch (problem) {
        // A trap leaves the instance in an unknown state.
        const fatal = problem instanceof WebAssembly.RuntimeError;
        reply({ type: "failed", id, error: toError(problem), fatal }, []);
      }
    }

    async function performAll(): Promise<void> {
      if (performing) return;
      performing = true;
      while (wanted.size > 0) {
        await turn();
        const [next] = wanted.values();
        if (!next) break;
        current = next.id;
        await perform(next);
        current = null;
        wanted.delete(next.id);
      }
      performing = false;
    }

    function stop(id: number): void {
      if (!wanted.delete(id) || id === current) return;
      reply({ type: "failed", id, error: STOPPED, fatal: false }, []);
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
      else if (ask.type === "stop") stop(ask.id);
      else {
        wanted.set(ask.id, ask);
        void performAll();
      }
    };
  };
}

const slowTurn = () => new Promise<void>((resolve) => setTimeout(resolve));

/** Turns that come behind what has been said already, and before all that will be: no timer is as quick. */
function quickTurns(): () => Promise<void> {
  const { port1, port2 } = new MessageChannel();
  let go = () => {};
  port1.onmessage = () => go();
  return () =>
    new Promise((resolve) => {
      go = resolve;
      port2.postMessage(null);
    });
}
