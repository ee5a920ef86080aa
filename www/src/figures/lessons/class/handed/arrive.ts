/** What becomes of a table when answers come in, by whatever way, and how that is said. */
import { type Answers, keyOf, latest } from "../answers";

export interface Arrival {
  answers: Answers;
  /** Whether the table had none of this pupil, or earlier ones, the same, or later ones, which stay. */
  outcome: "new" | "newer" | "same" | "older";
}

/** Takes answers into a table, one after the other. */
export function arrive(
  before: readonly Answers[],
  found: readonly Answers[],
): { all: Answers[]; arrivals: Arrival[] } {
  const byKey = new Map(before.map((one) => [keyOf(one), one]));
  const arrivals = found.map((answers): Arrival => {
    const there = byKey.get(keyOf(answers));
    const outcome = !there
      ? "new"
      : contentOf(there) === contentOf(answers)
        ? "same"
        : there.saved <= answers.saved
          ? "newer"
          : "older";
    if (outcome === "new" || outcome === "newer") byKey.set(keyOf(answers), answers);
    return { answers, outcome };
  });
  return { all: latest([...byKey.values()]), arrivals };
}

/** What was answered, without when: the same answers come by several ways. */
const contentOf = ({ items }: Answers) =>
  JSON.stringify(
    items.map(({ item, done, exercises, guess, right, truth, answer }) => [
      item,
      done,
      exercises,
      guess,
      right,
      truth,
      answer,
    ]),
  );

/** How much of the sheet is done. */
export const scoreOf = ({ items }: Answers) =>
  `${items.filter(({ done }) => done).length} of ${items.length}`;

/** One pupil, as it is said while codes are scanned. */
export function arrivalWords({ answers, outcome }: Arrival): string {
  const { name } = answers;
  if (outcome === "same") return `${name} is in the table already.`;
  if (outcome === "older") return `${name}: the table has later answers, which stay.`;
  const score = `${name}: ${scoreOf(answers)} done`;
  return outcome === "new" ? `${score}.` : `${score}, in place of earlier answers.`;
}

/** What could not be taken, counted. */
export interface Problems {
  damaged: number;
  later: number;
  more: boolean;
}

/** A line of a report. */
export interface Line {
  words: string;
  problem?: boolean;
}

/** The sheet that most of them are answers to, the first of such; undefined where there are none. */
export function mostOf(found: readonly Answers[]): string | undefined {
  const counts = new Map<string, number>();
  for (const { title } of found) counts.set(title, (counts.get(title) ?? 0) + 1);
  return [...counts].sort(([, p], [, q]) => q - p)[0]?.[0];
}

/** Many pupils at once. `title` is the sheet whose table is shown; answers to another are in a table of their own. */
export function reportOf(arrivals: readonly Arrival[], title: string): Line[] {
  const here = arrivals.filter(({ answers }) => answers.title === title);
  const elsewhere = arrivals.filter(({ answers }) => answers.title !== title);
  const names = (outcome: Arrival["outcome"]) =>
    here.filter((one) => one.outcome === outcome).map(({ answers }) => answers.name);
  const [added, newer, same, older] = [names("new"), names("newer"), names("same"), names("older")];
  const lines: Line[] = [];
  if (added.length > 0) lines.push({ words: `${people(added)} added to ${called(title)}.` });
  if (newer.length > 0)
    lines.push({ words: `${people(newer)}: later answers took the place of earlier ones.` });
  if (same.length > 0) lines.push({ words: `${people(same)}: in the table already.` });
  if (older.length > 0) lines.push({ words: `${people(older)}: the table has later answers, which stay.` });
  for (const other of [...new Set(elsewhere.map(({ answers }) => answers.title))]) {
    const who = elsewhere.filter(({ answers }) => answers.title === other).map(({ answers }) => answers.name);
    lines.push({
      words: `${people(who)} answered another sheet, ${called(other)}, which has a table of its own.`,
    });
  }
  return lines;
}

/** What could not be taken, and what to do about it. */
export function problemLines({ damaged, later, more }: Problems): Line[] {
  const lines: Line[] = [];
  if (damaged > 0) {
    const words =
      damaged === 1
        ? "One code was cut or changed on its way. Ask for it again."
        : `${damaged} codes were cut or changed on their way. Ask for them again.`;
    lines.push({ words, problem: true });
  }
  if (later > 0) {
    const words = `${later === 1 ? "One code comes" : `${later} codes come`} from a later version of Frond. Reload this page, and try again.`;
    lines.push({ words, problem: true });
  }
  if (more)
    lines.push({
      words: "There are more codes than are read at once. Bring in the rest by itself.",
      problem: true,
    });
  return lines;
}

export const called = (title: string) => (title === "" ? "a sheet without a title" : `“${title}”`);

const MOST_NAMES = 8;

/** Names, as far as they are read at a glance. */
function people(names: readonly string[]): string {
  const unique = [...new Set(names)];
  if (unique.length > MOST_NAMES) return `${unique.length} pupils`;
  const [last, ...others] = [...unique].reverse();
  return others.length === 0 ? (last ?? "") : `${others.reverse().join(", ")} and ${last}`;
}
