/** A graph as its knots and what each piece copies: what hands change, and what the maps follow from. */
import type { Graph, GraphPiece } from "#wasm/api";

export type Kind = Graph["kind"];
export type Knot = [t: number, x: number];

export interface Part {
  /** The roughness. */
  c: number;
  reflected: boolean;
  /** What it copies. */
  domain: [from: number, to: number];
}

export interface Model {
  kind: Kind;
  /** One more than parts, from left to right. */
  knots: Knot[];
  parts: Part[];
}

export const MOST_PIECES = 256;
export const MOST_C = 0.99;

/** Ends that are nearer than this part of the interval are one. */
const SAME_END = 1e-7;

/** The part of t that a piece fills. */
export function rangeOf({ map: [a, , , d], domain: [alpha, beta] }: GraphPiece): [number, number] {
  const ends = [a * alpha + d, a * beta + d] as const;
  return a < 0 ? [ends[1], ends[0]] : [ends[0], ends[1]];
}

/** What a graph is made of; `at` is the graph itself. */
export function modelOf(graph: Graph, at: (t: number) => number): Model {
  const ranges = graph.pieces.map(rangeOf);
  const ts = [...ranges.map(([from]) => from), ranges.at(-1)?.[1] ?? 1];
  const parts = graph.pieces.map(({ map, domain }): Part => {
    return { c: map[2], reflected: map[0] < 0, domain: [...domain] };
  });
  const model = { kind: graph.kind, knots: ts.map((t): Knot => [tidy(t), tidy(at(t))]), parts };
  // A domain that should end at a knot ends where the knot has come to lie.
  return { ...model, parts: parts.map((part) => ({ ...part, domain: onKnots(model.knots, part.domain) })) };
}

/** Without the last digits, in which numbers that were computed differ from those that were meant. */
function tidy(x: number): number {
  return Number(x.toPrecision(13));
}

function onKnots(knots: readonly Knot[], domain: [number, number]): [number, number] {
  return [at(knots, domain[0]), at(knots, domain[1])];
}

function at(knots: readonly Knot[], t: number): number {
  const index = knotAt(knots, t);
  return index === null ? t : (knots[index]?.[0] ?? t);
}

/** The knot at t, if there is one. */
function knotAt(knots: readonly Knot[], t: number): number | null {
  const [start, end] = interval(knots);
  const index = knots.findIndex((knot) => Math.abs(knot[0] - t) <= SAME_END * (end - start));
  return index < 0 ? null : index;
}

export function interval(knots: readonly Knot[]): [number, number] {
  return [knots[0]?.[0] ?? 0, knots.at(-1)?.[0] ?? 1];
}

/** What `interpolation` is asked for. */
export function request({ kind, knots, parts }: Model): {
  points: Knot[];
  options: { c: number[]; reflected: boolean[]; spans?: [number, number][]; domains?: [number, number][] };
} {
  const options = { c: parts.map(({ c }) => c), reflected: parts.map(({ reflected }) => reflected) };
  const points = knots.map(([t, x]): Knot => [t, x]);
  if (kind === "fif") return { points, options };
  if (kind === "pfif") {
    return { points, options: { ...options, domains: parts.map(({ domain }) => [...domain]) } };
  }
  return { points, options: { ...options, spans: parts.map(({ domain }) => spanOf(knots, domain)) } };
}

/** From which knot to which a domain runs. */
export function spanOf(knots: readonly Knot[], domain: readonly [number, number]): [number, number] {
  return [nearest(knots, domain[0]), nearest(knots, domain[1])];
}

function nearest(knots: readonly Knot[], t: number): number {
  let best = 0;
  for (const [i, knot] of knots.entries()) {
    if (Math.abs(knot[0] - t) < Math.abs((knots[best]?.[0] ?? 0) - t)) best = i;
  }
  return best;
}

/** The same graph to eleven digits of what is seen: links are short then. */
export function short(graph: Graph): Graph {
  const ranges = graph.pieces.map(rangeOf);
  const [start, end] = [ranges[0]?.[0] ?? 0, ranges.at(-1)?.[1] ?? 1];
  const long = end - start;
  const gain = Math.max(...graph.pieces.map(({ map }) => Math.abs(map[2])));
  const heights = graph.pieces.flatMap(({ map: [, b, , , e], domain }) =>
    domain.map((t) => Math.abs(b * t + e)),
  );
  const tall = Math.max(...heights) / Math.max(0.01, 1 - gain);
  // Far from t = 0, a little of a and b is much of what they do.
  const far = Math.max(Math.abs(start), Math.abs(end), long);
  const to = (unit: number) => {
    const digits = Math.min(20, Math.max(0, 11 - Math.ceil(Math.log10(unit))));
    return (x: number) => (unit > 0 && Number.isFinite(unit) ? Number(x.toFixed(digits)) + 0 : x);
  };
  const [scale, slope, factor, along, up] = [to(long / far), to(tall / far), to(1), to(long), to(tall)];
  const pieces = graph.pieces.map(({ map: [a, b, c, d, e], domain }): GraphPiece => {
    const map: GraphPiece["map"] = [scale(a), slope(b), factor(c), along(d), up(e)];
    return { map, domain: [along(domain[0]), along(domain[1])] };
  });
  return { ...graph, pieces };
}

/** A knot somewhere else: never past its neighbours. Domains that end at it go along. */
export function withKnot(model: Model, index: number, [t, x]: Knot): Model {
  const old = model.knots[index];
  if (!old || !Number.isFinite(t) || !Number.isFinite(x)) return model;
  const [start, end] = interval(model.knots);
  const room = 1e-4 * (end - start);
  const low = (model.knots[index - 1]?.[0] ?? Number.NEGATIVE_INFINITY) + room;
  const high = (model.knots[index + 1]?.[0] ?? Number.POSITIVE_INFINITY) - room;
  const next = Math.min(high, Math.max(low, t));
  if (next === old[0] && x === old[1]) return model;
  const knots = model.knots.map((knot, i): Knot => (i === index ? [next, x] : knot));
  const moved = interval(knots);
  const end_ = (z: number) =>
    knotAt(model.knots, z) === index ? next : Math.min(moved[1], Math.max(moved[0], z));
  return {
    ...model,
    knots,
    parts: model.parts.map((part) => ({ ...part, domain: [end_(part.domain[0]), end_(part.domain[1])] })),
  };
}

export function withPart(model: Model, index: number, change: Partial<Part>): Model {
  return { ...model, parts: model.parts.map((part, i) => (i === index ? { ...part, ...change } : part)) };
}

/** A knot more, in the middle of a piece, on the graph; both halves copy what the piece copied, as far as they may. */
export function withKnotIn(model: Model, piece: number, at_: (t: number) => number): Model {
  const [from, to] = [model.knots[piece], model.knots[piece + 1]];
  const part = model.parts[piece];
  if (!from || !to || !part || model.parts.length >= MOST_PIECES) return model;
  const t = tidy((from[0] + to[0]) / 2);
  const knots = [...model.knots];
  knots.splice(piece + 1, 0, [t, tidy(at_(t))]);
  const parts = [...model.parts];
  parts.splice(piece, 0, { ...part, domain: [...part.domain] });
  return { ...model, knots, parts };
}

/** Without a knot that is not an end. A domain that ended there ends at its neighbour, outwards. */
export function withoutKnot(model: Model, index: number): Model {
  if (index <= 0 || index >= model.knots.length - 1) return model;
  const gone = model.knots[index]?.[0] ?? 0;
  const [before, after] = [model.knots[index - 1]?.[0] ?? 0, model.knots[index + 1]?.[0] ?? 0];
  const knots = model.knots.filter((_, i) => i !== index);
  const whole = interval(knots);
  const parts = model.parts
    .filter((_, i) => i !== index)
    .map((part, i): Part => {
      let [alpha, beta] = part.domain;
      const near = SAME_END * (whole[1] - whole[0]);
      if (model.kind === "rfif") {
        if (Math.abs(alpha - gone) <= near) alpha = before;
        if (Math.abs(beta - gone) <= near) beta = after;
      }
      const [from, to] = [knots[i]?.[0] ?? 0, knots[i + 1]?.[0] ?? 1];
      // What became too long for what it copies copies all.
      const fits = beta - alpha > (to - from) * (1 + 1e-6);
      return { ...part, domain: fits ? [alpha, beta] : whole };
    });
  return { ...model, knots, parts };
}

/** The same knots as another kind: domains as near as that kind has them. */
export function asKind(model: Model, kind: Kind): Model {
  if (kind === model.kind) return model;
  const whole = interval(model.knots);
  if (kind === "pfif") return { ...model, kind };
  const parts = model.parts.map((part, i): Part => {
    if (kind === "fif") return { ...part, domain: whole };
    const span = spanOf(model.knots, part.domain);
    const domain: [number, number] = [
      model.knots[span[0]]?.[0] ?? whole[0],
      model.knots[span[1]]?.[0] ?? whole[1],
    ];
    const long = (model.knots[i + 1]?.[0] ?? 1) - (model.knots[i]?.[0] ?? 0);
    return { ...part, domain: domain[1] - domain[0] > long * (1 + 1e-9) ? domain : whole };
  });
  return { ...model, kind, parts };
}

/** The largest and the mean square distance of points from a graph. */
export function errorsOf(
  points: ArrayLike<number>,
  at_: (t: number) => number,
): { worst: number; meanSquare: number; where: number } {
  let [worst, sum, where] = [0, 0, points[0] ?? 0];
  for (let i = 0; i + 1 < points.length; i += 2) {
    const t = points[i] ?? 0;
    const off = Math.abs(at_(t) - (points[i + 1] ?? 0));
    sum += off * off;
    if (off > worst) [worst, where] = [off, t];
  }
  return { worst, meanSquare: sum / Math.max(1, points.length / 2), where };
}

/** The value of a graph, for many t at a time: the sum over its address. From the right where pieces do not meet. */
export function evaluator(graph: Graph): (t: number) => number {
  const ranges = graph.pieces.map(rangeOf);
  const starts = ranges.map(([from]) => from);
  const [start, end] = [starts[0] ?? 0, ranges.at(-1)?.[1] ?? 1];
  return (given) => {
    let t = Math.min(end, Math.max(start, given));
    let [sum, factor] = [0, 1];
    for (let depth = 0; depth < 4000 && Math.abs(factor) > 1e-14; depth++) {
      let [low, high] = [0, starts.length];
      while (high - low > 1) {
        const middle = (low + high) >> 1;
        if ((starts[middle] ?? 0) <= t) low = middle;
        else high = middle;
      }
      const piece = graph.pieces[low];
      if (!piece) return 0;
      const [a, b, c, d, e] = piece.map;
      const [alpha, beta] = piece.domain;
      t = Math.min(beta, Math.max(alpha, (t - d) / a));
      sum += factor * (b * t + e);
      factor *= c;
    }
    return sum;
  };
}
