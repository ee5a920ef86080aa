/** What is found of two shapes of a grid, in words. */
import { fixed } from "#format/numbers";
import type { GridIntersection } from "#wasm/api";
import type { StateWay } from "../graph/layout";

type Found = Pick<
  GridIntersection,
  "states" | "addresses" | "points" | "attractor" | "isExact" | "dimension"
>;

/** All copies of one kind in another. */
export interface Copies {
  from: number;
  to: number;
  /** Digits of the first shape, from 0. */
  digits: number[];
}

export function copiesOf({ states }: Pick<Found, "states">): Copies[] {
  return states.flatMap(({ copies }, from) => {
    const found = new Map<number, number[]>();
    for (const { digit, to } of copies) found.set(to, [...(found.get(to) ?? []), digit]);
    return [...found].map(([to, digits]) => ({ from, to, digits }));
  });
}

export function waysOf(found: Pick<Found, "states">): StateWay[] {
  return copiesOf(found).map(({ from, to, digits }) => ({ from, to, label: String(digits.length) }));
}

const counted = (count: number, one: string, many: string) =>
  `${count === 1 ? "one" : count} ${count === 1 ? one : many}`;

/** The graph in words, for those who do not see it. */
export function graphWords(found: Pick<Found, "states">): string {
  const parts = copiesOf(found)
    .slice(0, 12)
    .map(
      ({ from, to, digits }) =>
        `kind ${from} holds ${counted(digits.length, "copy", "copies")} of kind ${to}`,
    );
  return `${counted(found.states.length, "kind", "kinds")} of pieces: ${parts.join(", ")}${parts.length < 12 ? "" : " and so on"}.`;
}

export interface Verdict {
  title: string;
  text: string;
}

/** What the two share: nothing, points, one system, or several kinds of pieces. */
export function verdictOf({ states, addresses, points, attractor }: Found): Verdict {
  if (states.length === 0) {
    return {
      title: "They do not meet.",
      text: "Every pair of pieces comes apart after finitely many steps.",
    };
  }
  const count = points?.length ?? 0;
  if (typeof addresses === "number" && points === null) {
    return {
      title: "They share finitely many points.",
      text: `They have ${addresses} addresses in the first shape.`,
    };
  }
  if (typeof addresses === "number" && count === 1) {
    return {
      title: "They share one point.",
      text: `It has ${counted(addresses, "address", "addresses")} in the first shape.`,
    };
  }
  if (typeof addresses === "number") {
    return {
      title: `They share ${count} points, and no more.`,
      text: "Maps that shrink and can be undone have no attractor of two points or more that is finite: each would put all of them among themselves, nearer to each other. So here what they share is no attractor of such maps.",
    };
  }
  if (attractor) {
    return {
      title: `It is an attractor again, of ${counted(attractor.length, "map", "maps")}.`,
      text:
        states.length === 1
          ? "There is one kind of piece, made of copies of itself."
          : `There are ${states.length} kinds of pieces, and all ways through them come back to one: seen from there, each way round is a map.`,
    };
  }
  return {
    title: `It is made of ${states.length} kinds of pieces.`,
    text: `Each is made of copies of the others: a graph-directed system. No single system is seen in the graph; there may be one of other maps all the same.${
      addresses === "countable" ? " It has countably many points." : ""
    }`,
  };
}

/** Its dimension, and how sure that is. */
export function dimensionWords({ states, dimension, isExact }: Found): string {
  if (states.length === 0 || dimension === undefined) return "–";
  return `${isExact ? "" : "at most "}${fixed(dimension, 4)}`;
}
