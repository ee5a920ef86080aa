/** Which colour an edge of a closed curve has. */
import { GREY } from "#style/colours";
import type { Colouring } from "#wasm/api";

/** The colours of the edges, and for each edge which of them it has. */
interface EdgeColours {
  colours: string[];
  kinds: Uint16Array;
}

/**
 * Colours of the edges of a morph at s; null where the outline has one colour. `arcs` holds for each edge the arcs that
 * it copies at either end, first knot and number of edges, -1 and 0 where it is straight there.
 *
 * All copies of one arc have one colour, straight edges the first of the palette; between the ends colours go over.
 */
export function edgeColours(
  arcs: ArrayLike<number>,
  s: number,
  colouring: Colouring,
  palette: readonly string[],
): EdgeColours | null {
  if ((colouring !== "map" && colouring !== "address") || palette.length < 2) return null;
  const count = Math.floor(arcs.length / 4);
  const of = colouring === "map" ? [ranks(arcs, 0), ranks(arcs, 1)] : null;
  const plain = palette[0] ?? GREY;
  const another = (rank: number) => palette[1 + (rank % (palette.length - 1))] ?? plain;
  const known = new Map<string, number>();
  const kinds = new Uint16Array(count);
  for (let edge = 0; edge < count; edge++) {
    const [p, q] = [0, 1].map((end) => {
      const arc = arcAt(arcs, edge, end);
      if (arc === null) return plain;
      return another(of ? (of[end]?.get(arc) ?? 0) : edge);
    }) as [string, string];
    const colour = mixed(p, q, s);
    let kind = known.get(colour);
    if (kind === undefined) {
      kind = known.size;
      known.set(colour, kind);
    }
    kinds[edge] = kind;
  }
  return { colours: [...known.keys()], kinds };
}

/** The arcs of one end, numbered in the order in which they are first copied. */
function ranks(arcs: ArrayLike<number>, end: number): Map<number, number> {
  const found = new Map<number, number>();
  for (let edge = 0; 4 * edge < arcs.length; edge++) {
    const arc = arcAt(arcs, edge, end);
    if (arc !== null && !found.has(arc)) found.set(arc, found.size);
  }
  return found;
}

/** The arc that an edge copies at one end, as one number. */
function arcAt(arcs: ArrayLike<number>, edge: number, end: number): number | null {
  const [from = -1, span = 0] = [arcs[4 * edge + 2 * end], arcs[4 * edge + 2 * end + 1]];
  return from < 0 ? null : from * 65_536 + span;
}

/**
 * One colour on its way to another, both "#rrggbb", in sixteen steps: more are not told apart, and each costs a path.
 */
export function mixed(from: string, to: string, s: number): string {
  if (from === to) return from;
  const t = Math.round(16 * s) / 16;
  const channel = (colour: string, i: number) => Number.parseInt(colour.slice(1 + 2 * i, 3 + 2 * i), 16) || 0;
  const two = (i: number) =>
    Math.round(channel(from, i) + t * (channel(to, i) - channel(from, i)))
      .toString(16)
      .padStart(2, "0");
  return `#${two(0)}${two(1)}${two(2)}`;
}
