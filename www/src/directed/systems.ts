/** Graph-directed systems as they are edited: every change is a function from one to the next. */
import type { DirectedIfs, DirectedMap } from "#wasm/api";
import * as messages from "./messages";

/** As many states as there may be, and maps of each. */
export const MOST = 64;

/** A copy of half the size, that is put in when there has to be one. */
const half = (from: number): DirectedMap => ({ from, map: [0.5, 0, 0, 0.5, 0, 0] });

const withMaps = (system: DirectedIfs, state: number, change: (maps: DirectedMap[]) => DirectedMap[]) => ({
  states: system.states.map((maps, i) => (i === state ? change(maps) : maps)),
});

/** With another map in the place of one. */
export const replaced = (system: DirectedIfs, state: number, index: number, map: DirectedMap): DirectedIfs =>
  withMaps(system, state, (maps) => maps.map((old, i) => (i === index ? map : old)));

/** With one more map of a state: a copy of one of its maps. */
export const doubled = (system: DirectedIfs, state: number, index: number): DirectedIfs =>
  withMaps(system, state, (maps) => [...maps, maps[index] ?? half(state)]);

/** Without a map of a state, which keeps one. */
export const without = (system: DirectedIfs, state: number, index: number): DirectedIfs =>
  withMaps(system, state, (maps) => (maps.length > 1 ? maps.filter((_, i) => i !== index) : maps));

/** With a new state, made of four quarters of itself. */
export function extended({ states }: DirectedIfs): DirectedIfs {
  const from = states.length;
  const corners = [
    [0, 0],
    [0.5, 0],
    [0, 0.5],
    [0.5, 0.5],
  ] as const;
  return { states: [...states, corners.map(([x, y]) => ({ from, map: [0.5, 0, 0, 0.5, x, y] }))] };
}

/** Without its last state; maps that copied it copy the first from now on. */
export function shortened({ states }: DirectedIfs): DirectedIfs {
  const last = states.length - 1;
  if (last === 0) return { states };
  return {
    states: states
      .slice(0, last)
      .map((maps) => maps.map((map) => (map.from === last ? { ...map, from: 0 } : map))),
  };
}

/** What a state is made of, in words: "3 copies of state 2". */
export function madeOf(maps: readonly DirectedMap[]): string {
  const counts = new Map<number, number>();
  for (const { from } of maps) counts.set(from, (counts.get(from) ?? 0) + 1);
  return [...counts]
    .sort(([p], [q]) => p - q)
    .map(([from, count]) => messages.copiesOf(count, from + 1))
    .join(", ");
}
