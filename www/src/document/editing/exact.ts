/** Formulas that entries of maps mean exactly, read by a module that is fetched for them. */
import { type ReadonlySignal, signal } from "@preact/signals";
import { doubles } from "#geometry/maps/exact";
import { loadExact } from "#wasm/exact";

/** An exact number: the double nearest to it, and a short formula of it or its opposite. */
export interface ExactNumber {
  value: number;
  formula: string;
}

const reads = signal(0);

/** Grows when doubles of formulas have become known. */
export const formulasRead: ReadonlySignal<number> = reads;

/**
 * Reads formulas; null for each that stands for no number of the fields that Frond computes in. Rejects if the module
 * cannot be fetched.
 */
export async function readExact(formulas: readonly string[]): Promise<(ExactNumber | null)[]> {
  const { readNumbers } = await loadExact();
  const found = readNumbers([...formulas]).map((one) => ("problem" in one ? null : one));
  reads.value++;
  return found.map((one) => one && { value: one.value, formula: learn(linked(one.text), one.value) });
}

/** Learns a double, and gives the formula back; without a minus before all of it, since opposites are meant, too. */
function learn(formula: string, value: number): string {
  const isOpposite = /^-[^+-]*$/.test(formula);
  const kept = isOpposite ? formula.slice(1) : formula;
  doubles.set(kept, isOpposite ? -value : value);
  return kept;
}

/** The formula among these that an entry of a map means; of its opposite with a minus. */
export function formulaAt(x: number, formulas: readonly string[]): string | undefined {
  const formula = formulas.find((one) => Math.abs(doubles.get(one) ?? Number.NaN) === Math.abs(x));
  if (formula === undefined || doubles.get(formula) === x) return formula;
  const isTerm = !/[+-]/.test(formula) || /^\(.*\)\/\d+$/.test(formula);
  return isTerm ? `-${formula}` : `-(${formula})`;
}

/** In the words of a link. */
const linked = (text: string) =>
  text
    .replace(/\s/g, "")
    .replace(/√(\d+)/g, "sqrt($1)")
    .replace(/\^/g, "**");

/** Learns the doubles of formulas that came with a link. */
export async function learnFormulas(formulas: readonly string[]): Promise<void> {
  const unknown = formulas.filter((formula) => !doubles.has(formula));
  if (unknown.length === 0) return;
  const found = await readExact(unknown);
  for (const [k, formula] of unknown.entries()) {
    const one = found[k];
    if (one) doubles.set(formula, one.value);
  }
  reads.value++;
}
