/** What a class guessed, counted: how many chose what, and numbers in a few steps. */
import { type Answer, type Answers, askedOf } from "../answers";

export interface Count {
  label: string;
  count: number;
  /** Whether this is so. */
  so: boolean;
}

export interface Counted {
  item: string;
  /** How many guessed, of so many that were asked. */
  guessed: number;
  asked: number;
  /** How many of them were right; null where that is not known. */
  right: number | null;
  /** Numbers in their order, and choices by how many made them. */
  counts: Count[];
}

const NUMBER = /^-?\d+(?:\.\d+)?$/;
/** So many different numbers stand one by one; more in steps. */
const MOST_SINGLE = 8;
const MOST_STEPS = 10;

/** For each question that anybody has guessed at. */
export function countsOf(all: readonly Answers[]): Counted[] {
  return askedOf(all).flatMap((item) => {
    const answers = all.flatMap(({ items }) => items.find((one) => one.item === item) ?? []);
    const guesses = answers.filter(({ guess }) => guess !== "");
    if (guesses.length === 0) return [];
    const judged = guesses.filter(({ right }) => right !== undefined);
    return [
      {
        item,
        guessed: guesses.length,
        asked: answers.length,
        right: judged.length === 0 ? null : judged.filter(({ right }) => right).length,
        counts: guesses.every(({ guess }) => NUMBER.test(guess)) ? numbers(guesses) : choices(guesses),
      },
    ];
  });
}

/** What is so, where a page has said it. */
const truthIn = (guesses: readonly Answer[]) => guesses.find(({ truth }) => truth !== undefined)?.truth;

function choices(guesses: readonly Answer[]): Count[] {
  const truth = truthIn(guesses);
  const counts = new Map<string, number>();
  for (const { guess } of guesses) counts.set(guess, (counts.get(guess) ?? 0) + 1);
  // What nobody chose, though it is so, is worth seeing.
  if (truth !== undefined && !counts.has(truth)) counts.set(truth, 0);
  return [...counts]
    .map(([label, count]) => ({ label, count, so: label === truth }))
    .sort((p, q) => q.count - p.count || p.label.localeCompare(q.label));
}

function numbers(guesses: readonly Answer[]): Count[] {
  const said = truthIn(guesses);
  const truth = said !== undefined && NUMBER.test(said) ? Number(said) : null;
  const values = guesses.map(({ guess }) => Number(guess));
  const shown = [...values, ...(truth === null ? [] : [truth])];
  const single = [...new Set(shown)].sort((p, q) => p - q);
  if (single.length <= MOST_SINGLE) {
    return single.map((one) => ({
      label: String(one),
      count: values.filter((value) => value === one).length,
      so: one === truth,
    }));
  }
  const [low, high] = [Math.min(...shown), Math.max(...shown)];
  const step = stepFor(high - low);
  // Rounding must not push a value that is on a border over it.
  const place = (value: number) => Math.floor(value / step + 1e-9);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const first = place(low);
  return Array.from({ length: place(high) - first + 1 }, (_, i) => {
    const at = first + i;
    return {
      label: `${(at * step).toFixed(digits)} to ${((at + 1) * step).toFixed(digits)}`,
      count: values.filter((value) => place(value) === at).length,
      so: truth !== null && place(truth) === at,
    };
  });
}

/** A round step, of which a range has no more than a few. */
function stepFor(range: number): number {
  const least = range / (MOST_STEPS - 1);
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5].find((one) => one * power >= least) ?? 10);
}
