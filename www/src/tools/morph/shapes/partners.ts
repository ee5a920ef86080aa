/**
 * Which shapes of the gallery have a way to each other that holds: too long to be found while somebody chooses, so it
 * is a table of what eight seconds a pair have found. `cargo run --release -p frond-locus --example pairs -- all`
 * prints it; a test of that crate asks whether it is true.
 */

import * as messages from "../messages";
import table from "./partners.txt?raw";

/** How they come together: as they are, or by another way, which is offered once it is found. */
export type Bond = "plain" | "other";

const BONDS: Record<string, Bond> = { "=": "plain", "+": "other" };

/** The shapes that hold all the way to or from this one, by id. */
export function partnersOf(id: string, rows: string = table): Map<string, Bond> {
  const lines = rows.trim().split("\n");
  const cells = lines.map((line) => line.trim().split(/\s+/));
  const own = cells.find(([name]) => name === id)?.[1] ?? "";
  const found = new Map<string, Bond>();
  cells.forEach(([name = ""], k) => {
    const bond = BONDS[own[k] ?? ""];
    if (bond && name !== id) found.set(name, bond);
  });
  return found;
}

/** What is said of a shape that is chosen to come together with another. */
export const bondWords = (bond: Bond, other: string): string =>
  bond === "plain" ? messages.staysInOnePiece(other) : messages.canStayInOne(other);
