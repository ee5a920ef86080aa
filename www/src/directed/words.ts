/** What is said of graph-directed shapes. */
import type { DirectedIfs } from "#wasm/api";

/** How much a shape is made of: "2 states, 7 maps". A system of maps has one state, of which nothing is said. */
export function sizeWords({ states }: DirectedIfs): string {
  const maps = states.reduce((sum, state) => sum + state.length, 0);
  const words = `${maps} ${maps === 1 ? "map" : "maps"}`;
  return states.length === 1 ? words : `${states.length} states, ${words}`;
}

/** The same as short as a card has room for. */
export function stateWords({ states }: DirectedIfs): string {
  return states.length === 1 ? "1 state" : `${states.length} states`;
}
