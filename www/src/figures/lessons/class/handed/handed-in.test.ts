import "fake-indexeddb/auto";
import { IDBFactory } from "fake-indexeddb";
import { afterEach, beforeEach, expect, it } from "vitest";
import { Database } from "#document/kept/database";
import type { Answers } from "../answers";
import { HandedIn } from "./handed-in";
import { spreadsheet } from "./spreadsheet";

let database: Database;
let kept: HandedIn;

beforeEach(() => {
  globalThis.indexedDB = new IDBFactory();
  database = new Database();
  kept = new HandedIn(database);
});
afterEach(() => database.close());

const answers = (name: string, title: string, day: number, answer = ""): Answers => ({
  name,
  title,
  saved: `2026-01-0${day}T10:00:00Z`,
  items: [{ item: "e1", done: true, exercises: [1, 2], guess: "-0.35", right: false, truth: "0.4", answer }],
});

it("gives back what was handed in, after the page is loaded anew", async () => {
  await kept.keep([answers("Ben", "M", 1), answers("Ana", "M", 2)]);
  await database.close();
  expect((await new HandedIn(new Database()).list()).map(({ name }) => name)).toEqual(["Ana", "Ben"]);
});

it("keeps the latest of each name, and what the same pupil answered to another sheet", async () => {
  await kept.keep([answers("Ana", "M", 2, "new"), answers("Ana", "Ferns", 1)]);
  await kept.keep([answers("Ana", "M", 1, "old")]);
  const found = await kept.list();
  expect(found.map(({ title }) => title).sort()).toEqual(["Ferns", "M"]);
  expect(found.find(({ title }) => title === "M")?.items[0]?.answer).toBe("new");
});

it("removes what it is told to, and leaves the rest", async () => {
  await kept.keep([answers("Ana", "M", 2), answers("Ben", "Ferns", 1)]);
  await kept.remove([answers("Ana", "M", 2)]);
  expect((await kept.list()).map(({ name }) => name)).toEqual(["Ben"]);
});

it("leaves out what has not its form", async () => {
  await kept.keep([answers("Ana", "M", 2)]);
  await database.change("answers", (rows) => rows.put({ id: "x", name: "Eve", items: [{ item: "<b>" }] }));
  expect((await kept.list()).map(({ name }) => name)).toEqual(["Ana"]);
});

it("writes a row a pupil for a spreadsheet, in which no words are a formula", () => {
  const other = { ...answers("Ben", "M", 1), items: [] };
  const text = spreadsheet([answers("=Ana", "M", 2, 'They "part",\nsee'), other], () => "Lesson 5");
  expect(text).toBe(
    [
      '\uFEFF"Name","Saved","Lesson 5: done","Lesson 5: solved","Lesson 5: guess","Lesson 5: right","Lesson 5: it is","Lesson 5: answer"',
      `"'=Ana","2026-01-02T10:00:00Z","yes","1 2","-0.35","no","0.4","They ""part"",\nsee"`,
      '"Ben","2026-01-01T10:00:00Z","not asked","","","","",""',
      "",
    ].join("\r\n"),
  );
});
