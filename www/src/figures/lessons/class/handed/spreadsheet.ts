/** What a class has handed in as a file for a spreadsheet: RFC 4180, a row a pupil. */
import { type Answers, askedOf } from "../answers";

/** So that spreadsheets read it as UTF-8. */
const MARK = "\uFEFF";

/** For each item whether it is done, what was solved, guessed and written; `called` gives its name. */
export function spreadsheet(all: readonly Answers[], called: (item: string) => string): string {
  const asked = askedOf(all);
  const head = asked.flatMap((item) => {
    const name = called(item);
    return ["done", "solved", "guess", "right", "it is", "answer"].map((what) => `${name}: ${what}`);
  });
  const rows = all.map(({ name, saved, items }) => [
    name,
    saved,
    ...asked.flatMap((wanted) => {
      const found = items.find(({ item }) => item === wanted);
      if (!found) return ["not asked", "", "", "", "", ""];
      const { done, exercises, guess, right, truth = "", answer } = found;
      return [
        yesNo(done),
        exercises.join(" "),
        guess,
        right === undefined ? "" : yesNo(right),
        truth,
        answer,
      ];
    }),
  ]);
  const lines = [["Name", "Saved", ...head], ...rows].map((cells) => cells.map(cell).join(","));
  return `${MARK}${lines.join("\r\n")}\r\n`;
}

const yesNo = (is: boolean) => (is ? "yes" : "no");

/** A pupil's words are never a formula of the teacher's spreadsheet; a number stays one. */
function cell(words: string): string {
  const plain = /^[=+\-@\t\r]/.test(words) && !/^[-+]?[\d.,]+$/.test(words) ? `'${words}` : words;
  return `"${plain.replaceAll('"', '""')}"`;
}
