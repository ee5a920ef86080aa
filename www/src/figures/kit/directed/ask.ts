/** What pages ask the workers about graph-directed shapes. */
import { useEffect, useRef, useState } from "preact/hooks";
import { toError } from "#wasm/error";
import { directedTask } from "#workers/directed/client";
import type { Tasks } from "#workers/directed/tasks";
import { InTurn, isStopped } from "#workers/lanes/latest";
import type { Args, Result } from "#workers/lanes/task";

interface Answer<K extends keyof Tasks> {
  about: Args<Tasks, K>;
  result: Result<Tasks, K> | null;
  problem: string | null;
}

/**
 * The last answer to a question, which may still be about the one before: while one is under way only the latest wish
 * waits, so that something is seen during a drag.
 */
export function useDirected<K extends Extract<keyof Tasks, string>>(
  name: K,
  args: Args<Tasks, K> | null,
  lane: 0 | 1,
): Answer<K> | null {
  const [answer, setAnswer] = useState<Answer<K> | null>(null);
  const [turn] = useState(() => new InTurn());
  const end = useRef(new AbortController());
  useEffect(() => {
    const own = new AbortController();
    end.current = own;
    return () => own.abort();
  }, []);
  useEffect(() => {
    if (args === null) return;
    const { signal } = end.current;
    turn.ask(async () => {
      try {
        const result = await directedTask(name, args, { lane, signal });
        if (!signal.aborted) setAnswer({ about: args, result, problem: null });
      } catch (problem) {
        if (!isStopped(problem) && !signal.aborted) {
          setAnswer({ about: args, result: null, problem: toError(problem).message });
        }
      }
    });
    return () => turn.clear();
  }, [name, args, lane, turn]);
  return answer;
}
