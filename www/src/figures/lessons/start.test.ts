import { expect, it } from "vitest";
import { sheetIn } from "./class/sheet";
import { LESSONS } from "./course";
import { WAYS } from "./start";

it("leads to lessons that there are, and to a sheet that opens", () => {
  const ids = LESSONS.map(({ id }) => id);
  for (const { lessons } of WAYS) {
    expect(ids).toEqual(expect.arrayContaining([...lessons]));
    expect(sheetIn(`lessons=${lessons.join(",")}`)?.sheet.lessons).toEqual(lessons);
  }
});

it("offers forty minutes at most to whoever has no more, the exercises as long as the lessons", () => {
  const forty = WAYS.find(({ sheet }) => sheet)?.lessons ?? [];
  const minutes = LESSONS.filter(({ id }) => forty.includes(id)).reduce((sum, one) => sum + one.minutes, 0);
  expect(2 * minutes).toBeLessThanOrEqual(40);
});
