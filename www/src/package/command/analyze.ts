/** What the ways in which the pieces of a shape touch tell of it, in words or as JSON. */
import "#geometry/maps/exact-gallery";
import { exactOf } from "#geometry/maps/exact";
import { weighted } from "#geometry/maps/weighted";
import type { Analysis, Dimension, Ifs } from "#wasm/api";
import { mapsOf } from "./answers";
import { number, type Options, Refusal, whole } from "./options";
import { noMoments, subjectOf } from "./subject";
import type { System } from "./system";

/** Maps, and the formulas of numbers that some of their entries stand for. */
interface Meant {
  ifs: Ifs;
  numbers: readonly string[];
}

export async function analyze(word: string, options: Options, system: System): Promise<number> {
  const budget = whole(options, "budget", 1, 1_000_000, 20_000);
  const given = numbersOf(options);
  const { ifs, numbers } = await meant(word, options, system);
  const { analyze, readNumbers } = await system.exact();
  const meantBy = [...(given ?? numbers)];
  readNumbers(meantBy).forEach((found, k) => {
    if ("problem" in found) throw new Refusal(`"${meantBy[k]}" is no exact number: ${found.problem}.`);
  });
  const found = analyze(ifs, meantBy, { budget });
  if (options["json"]) system.print(JSON.stringify({ ...found, numbers: meantBy }, null, 2));
  else for (const line of wordsOf(found)) system.print(line);
  return found.openSetCondition === "undecided" && !found.dimension?.proved ? 1 : 0;
}

/** --numbers: formulas, separated by commas. */
function numbersOf({ numbers }: Options): string[] | null {
  if (numbers === undefined) return null;
  const all = String(numbers)
    .split(",")
    .map((formula) => formula.trim());
  if (all.includes(""))
    throw new Refusal(`--numbers is a list of formulas such as 1/3,sqrt(3)/6, and not "${numbers}".`);
  return all;
}

/** The ends of a morph mean what their shapes say; between them numbers are what they are. */
async function meant(word: string, options: Options, system: System): Promise<Meant> {
  const subject = await subjectOf(word, system);
  noMoments(subject, options);
  const { scene, maps } = subject;
  if (maps) return { ifs: bare(maps), numbers: [] };
  const t = number(options, "t", 0, 1, scene.t);
  const isPlain = !(scene.directed || scene.curves || scene.tool === "fit" || scene.tool === "space");
  if (isPlain && (t === 0 || t === 1)) {
    const shape = t === 0 ? scene.a : scene.b;
    return { ifs: { maps: shape.maps }, numbers: exactOf(shape) };
  }
  return { ifs: bare(await mapsOf(word, options, system)), numbers: [] };
}

const bare = ({ maps, probabilities }: Ifs): Ifs => weighted(maps, probabilities);

const CONDITION: Readonly<Record<Analysis["openSetCondition"], string>> = {
  yes: "yes, proved",
  no: "no, proved: two words of maps give the same piece",
  undecided: "not decided",
};

function wordsOf({ openSetCondition, neighbours, dimension, boundary, innerPoints, reasons }: Analysis) {
  const rows = [
    ["Open set condition", CONDITION[openSetCondition]],
    ["Neighbours", neighbours === null ? "not all found" : String(neighbours)],
    ["Dimension", dimension === null ? "not decided" : dimensionOf(dimension)],
    ["Inner points", innerPoints === null ? "not decided" : innerPoints ? "yes, proved" : "none, proved"],
    ...(boundary ? [["Dimension of the boundary", dimensionOf(boundary.dimension)]] : []),
  ] as const;
  return [
    ...rows.map(([what, answer]) => `${what}: ${answer}.`),
    ...reasons.flatMap(({ kind, count = 0, words }) => REASONS[kind]?.(count, words) ?? []),
  ];
}

function dimensionOf({ value, lower, upper, proved, exact }: Dimension): string {
  if (!proved) return `at most ${upper}`;
  if (exact !== null) return /^\d+$/.test(exact) ? `${exact}, proved` : `${exact} = ${value}, proved`;
  return lower === upper ? `${value}, proved` : `${value}, proved to lie between ${lower} and ${upper}`;
}

const letters = (word: readonly number[]) => word.map((map) => map + 1).join(".");

/** Those that the answers do not say themselves. */
const REASONS: Readonly<Record<string, (count: number, words?: [number[], number[]]) => string>> = {
  "exact-overlap": (_, words = [[], []]) =>
    `The words ${letters(words[0])} and ${letters(words[1])} give the same piece.`,
  "types-counted": (count) => `Pieces were counted once each, by ${count} types of what is around them.`,
  "budget-spent": (count) =>
    `The search ended at ${count} pairs of pieces: with a larger --budget it looks at more.`,
  "not-strongly-connected": () => "Not every state is part of every other.",
  "ratios-differ": () => "Some pieces are the same, and not all maps scale by one factor.",
  "not-shrinking": () => "A map alone does not make things smaller.",
};
