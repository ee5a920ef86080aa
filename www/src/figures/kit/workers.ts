/** What the figures ask of the workers. */
import type { ReadonlySignal } from "@preact/signals";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { EPSILON } from "#compute/locus/job";
import { type Uv, uvAt } from "#geometry/path";
import { STATE } from "#geometry/states";
import type { Connectedness, FrondError, MapRow, MorphOptions } from "#wasm/api";
import { Coalesce } from "#workers/pool/coalesce";
import { cancel, epoch, submit } from "#workers/pool/engine";
import { type Channel, type Job, type Kind, type Result, single, type Task } from "#workers/pool/protocol";

/** A signal's value, as something that effects and memos depend on. */
export function useValue<T>(signal: ReadonlySignal<T>): T {
  return signal.value;
}

let channels = 0;

/** A channel of one's own, given up with the component. */
export function useChannel(): Channel {
  const [channel] = useState<Channel>(() => `figure:${++channels}`);
  useEffect(() => () => cancel(channel), [channel]);
  return channel;
}

/**
 * Asks for one thing whenever `task` is another object. While one is under way only the latest wish waits, so that
 * something is seen during a drag; answers come in order.
 */
export function useAsk<K extends Kind>(
  task: Task<K> | null,
  priority: number,
  then: { accept(task: Task<K>, result: Result<K>): void; fail?(task: Task<K>, error: FrondError): void },
): void {
  const channel = useChannel();
  const [queue] = useState(() => new Coalesce(submit));
  const latest = useRef(then);
  latest.current = then;
  const host = useValue(epoch);
  const asked = useRef(host);
  useEffect(() => {
    if (asked.current !== host) queue.reset();
    asked.current = host;
    if (!task) return;
    queue.request(() =>
      single<K>(channel, priority, task, {
        accept: (result) => latest.current.accept(task, result),
        fail: (error) => latest.current.fail?.(task, error),
      }),
    );
  }, [task, host, channel, queue, priority]);
}

export interface Judged {
  /** Which maps the answer is about. */
  maps: MapRow[];
  answer: Connectedness;
}

/** Whether an attractor is in one piece: the last answer, which may still be about the maps before. */
export function useVerdict(maps: MapRow[] | null, epsilon = EPSILON, priority = 46): Judged | null {
  const [judged, setJudged] = useState<Judged | null>(null);
  const task = useMemo<Task<"verdict"> | null>(
    () => (maps ? { kind: "verdict", maps, epsilon } : null),
    [maps, epsilon],
  );
  useAsk<"verdict">(task, priority, {
    accept: (about, answer) => setJudged({ maps: about.maps, answer }),
    fail: (about, error) => setJudged({ maps: about.maps, answer: noAnswer(about.maps, error) }),
  });
  return judged;
}

function noAnswer(maps: MapRow[], error: FrondError): Connectedness {
  return {
    verdict: error.code === "worker-lost" ? "undecided" : "no-attractor",
    gap: { lower: 0, upper: 0 },
    overlaps: [],
    components: maps.map((_, i) => i),
    count: maps.length,
    diameter: 0,
    nodes: 0,
  };
}

export interface Way {
  from: MapRow[];
  to: MapRow[];
  options: MorphOptions;
  points: readonly Uv[];
}

/** Samples of a path, and in one slice. */
export const SAMPLES = 481;
const SLICE = 24;

/** The state of the morph at `SAMPLES` even moments of a path, or null until all are in. */
export function useStates(way: Way | null): Uint8Array | null {
  const channel = useChannel();
  const [done, setDone] = useState<{ way: Way; states: Uint8Array } | null>(null);
  const host = useValue(epoch);
  // biome-ignore lint/correctness/useExhaustiveDependencies: a new host has to be asked anew
  useEffect(() => {
    if (way) submit(statesJob(channel, way, (states) => setDone({ way, states })));
  }, [channel, way, host]);
  return done && done.way === way ? done.states : null;
}

function statesJob(channel: Channel, way: Way, done: (states: Uint8Array) => void): Job<"states"> {
  const states = new Uint8Array(SAMPLES).fill(STATE.undecided);
  const firsts = new Map<object, number>();
  const options = { ...way.options, epsilon: EPSILON };
  let from = 0;
  return {
    channel,
    priority: () => 42,
    next() {
      if (from >= SAMPLES) return null;
      const count = Math.min(SLICE, SAMPLES - from);
      const points = Array.from({ length: count }, (_, i) => uvAt(way.points, (from + i) / (SAMPLES - 1)));
      const task: Task<"states"> = { kind: "states", from: way.from, to: way.to, options, points };
      firsts.set(task, from);
      from += count;
      return task;
    },
    accept: (task, result) => states.set(result, firsts.get(task) ?? 0),
    // What could not be judged counts as undecided.
    fail() {},
    done: () => done(states),
  };
}
