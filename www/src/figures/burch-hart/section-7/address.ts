/** A graph-directed system in its page's address: states by colons, maps by semicolons, each with what it copies. */
import { MOST } from "#directed/systems";
import type { DirectedIfs } from "#wasm/api";
import { type Field, list, number } from "../../kit/state/fields";

/** What is longer is not written: the link opens what it was made from. */
const LONGEST = 3000;

const ROW = list(number(-1000, 1000, 6), 7, 7);
const STATES = list(list(ROW, 1, MOST, ";"), 1, MOST, ":");

/** The system; null stands for none of one's own. */
export const SYSTEM: Field<DirectedIfs | null> = {
  write(system) {
    const text = system
      ? STATES.write(system.states.map((maps) => maps.map(({ from, map }) => [from, ...map])))
      : "";
    return text.length <= LONGEST ? text : "";
  },
  read(text) {
    const states = STATES.read(text);
    if (!states) return null;
    const known = (from: number | undefined) =>
      from !== undefined && Number.isInteger(from) && from >= 0 && from < states.length;
    if (!states.flat().every(([from]) => known(from))) return null;
    return {
      states: states.map((maps) =>
        maps.map(([from = 0, a = 0, b = 0, c = 0, d = 0, e = 0, f = 0]) => ({
          from,
          map: [a, b, c, d, e, f],
        })),
      ),
    };
  },
};
