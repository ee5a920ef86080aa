import { expect, it } from "vitest";
import { LESSONS } from "./course";
import type { Teaching } from "./frame/teaching";

const modules = import.meta.glob<{ TEACHING: Teaching }>("./lesson-*/teaching.ts", { eager: true });
const sources = import.meta.glob<string>("./lesson-*/*.tsx", {
  eager: true,
  query: "?raw",
  import: "default",
});

/** How many exercises the sources of a lesson number. */
function exercisesOf(folder: string): number {
  const all = Object.entries(sources).filter(([file]) => file.startsWith(`./${folder}/`));
  const numbers = all.flatMap(([, source]) => [...source.matchAll(/\bnumber=\{(\d+)\}/g)].map(([, n]) => n));
  return new Set(numbers).size;
}

it("answers each guess among a few in words of its own", () => {
  for (const [file, source] of Object.entries(sources))
    if (/<Choices[\s<]/.test(source)) expect(source, file).toContain("<Reply");
});

it.each(LESSONS.map(({ id, title }) => [id, title]))("%s, %s, has words for teachers", (id) => {
  const folder = id.replace("e", "lesson-");
  const { TEACHING: teaching } = modules[`./${folder}/teaching.ts`] ?? {};
  if (!teaching) throw new Error("There are none.");
  expect(teaching.questions.length).toBeGreaterThanOrEqual(3);
  expect(teaching.mistakes.length).toBeGreaterThanOrEqual(2);
  const all = [teaching.aim, ...teaching.mistakes, teaching.answer, ...teaching.solutions];
  for (const words of [...all, ...teaching.questions.flatMap(({ ask, answer }) => [ask, answer])])
    expect(words).toMatch(/^.{2,}[.?”]$/su);
  // A handout has a solution of every exercise.
  expect(teaching.solutions.length).toBeGreaterThanOrEqual(2);
  expect(teaching.solutions.length).toBe(exercisesOf(folder));
  expect(teaching.onPaper.length).toBe(teaching.solutions.length);
  for (const { ask, answer } of teaching.onPaper.filter((one) => one !== "same")) {
    expect(ask).toMatch(/^.{2,}[.?)]$/su);
    expect(answer).toMatch(/^.{2,}[.”]$/su);
    // What only the page can do.
    expect(ask).not.toMatch(/\b(slider|drag|press|click|board)\b/i);
  }
});
