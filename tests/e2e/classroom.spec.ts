/** Lessons before a class: slides, handouts, and the sheet that goes round. */
import { readFile } from "node:fs/promises";
import { expectClean } from "./axe";
import { openFigure } from "./figure-pages";
import { expect, test } from "./fixture";

test("a lesson is shown step by step by keys, with a dot for the mouse, and left by Escape", async ({
  page,
}) => {
  await openFigure(page, "e6");
  await page.getByRole("button", { name: "Show as slides" }).click();
  const bar = page.getByRole("toolbar", { name: "Slides" });
  // Its words and its picture are one slide.
  await expect(bar).toContainText("1 of 4");
  await expect(page.getByRole("banner")).toBeHidden();
  await expect(page.getByRole("heading", { name: "Half-way round" })).toBeVisible();
  await expect(page.getByRole("region", { name: "The picture" })).toBeVisible();
  await expect(page.getByRole("button", { name: "Show me" })).toBeHidden();
  await page.keyboard.press("PageDown");
  await expect(page.getByTestId("badge")).toBeHidden();
  await expect(bar).toContainText("2 of 4 What do you think?");
  await expectClean(page);
  // A slider keeps its arrows; the Page keys go on all the same.
  await page.keyboard.press("PageDown");
  const slider = page.getByRole("slider", { name: "Turn at the beginning" });
  await slider.press("ArrowRight");
  await expect(bar).toContainText("3 of 4");
  await slider.press("PageUp");
  await expect(bar).toContainText("2 of 4");
  const pointer = bar.getByRole("button", { name: "Pointer" });
  await page.keyboard.press("l");
  await expect(pointer).toHaveAttribute("aria-pressed", "true");
  await page.keyboard.press("Escape");
  await expect(bar).toHaveCount(0);
  await expect(page.getByRole("banner")).toBeVisible();
  await expect(page.getByRole("button", { name: "Show as slides" })).toBeVisible();
});

test("a link leads to a slide, and says so where it was copied", async ({ page }) => {
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.goto("./#learn/e6/slide=3");
  const bar = page.getByRole("toolbar", { name: "Slides" });
  await expect(bar).toContainText("2 of 4 What do you think?");
  await page.keyboard.press("PageDown");
  await expect(bar).toContainText("3 of 4");
  // On paper it is the whole lesson all the same.
  await page.emulateMedia({ media: "print" });
  await expect(bar).toBeHidden();
  await expect(page.getByText("Exercise 2", { exact: true })).toBeVisible();
  await page.emulateMedia({ media: null });
  await bar.getByRole("button", { name: "Link" }).click();
  await expect(bar).toContainText("Link copied");
  expect(await page.evaluate(() => navigator.clipboard.readText())).toMatch(/#learn\/e6\/slide=4$/);
  await page.keyboard.press("Escape");
  await expect(bar).toHaveCount(0);
});

test("a slide is as large as it fits the window, and says when it goes on below", async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 720 });
  const main = page.locator("main");
  const hidden = () => main.evaluate((box) => box.scrollHeight - box.clientHeight);
  const more = page.getByRole("button", { name: "More below" });
  await page.goto("./#learn/e21/slide=4");
  await expect(page.getByRole("toolbar", { name: "Slides" })).toContainText("3 of 4 Exercise 1");
  await expect.poll(hidden).toBe(0);
  await expect(more).toHaveCount(0);
  await page.goto("./#learn/e12/guess=all&shown=1&slide=3");
  await expect(page.getByTestId("truth")).toBeVisible();
  await expect.poll(hidden).toBeGreaterThan(100);
  await more.click();
  await expect.poll(() => main.evaluate((box) => box.scrollTop)).toBeGreaterThan(100);
  await expect(more).toHaveCount(0);
});

test("slides begin unanswered, whatever was tried on the page, which is as it was afterwards", async ({
  page,
}) => {
  await openFigure(page, "e1");
  const guess = page.getByRole("slider", { name: "Scale of piece 1" });
  const truth = page.getByTestId("truth");
  await guess.press("ArrowLeft");
  await page.getByRole("button", { name: "Show me" }).click();
  await expect(truth).toContainText("You said 0.499");
  const marks = () => page.evaluate(() => `${localStorage["frond.guesses"]} ${localStorage["frond.done"]}`);
  const before = await marks();
  await page.getByRole("button", { name: "Show as slides" }).click();
  await page.keyboard.press("PageDown");
  await expect(page.getByRole("button", { name: "Show me" })).toBeDisabled();
  await expect(truth).toHaveCount(0);
  // What the class says is the class's, and gone with the slides.
  await guess.press("ArrowLeft");
  await guess.press("ArrowLeft");
  await page.getByRole("button", { name: "Show me" }).click();
  await expect(truth).toContainText("You said 0.498");
  await page.keyboard.press("Escape");
  await expect(truth).toContainText("You said 0.499");
  expect(await marks()).toBe(before);
});

test("slides have a black screen, a timer and a list of their keys", async ({ page }) => {
  await page.goto("./#learn/e6/slide=3");
  const bar = page.getByRole("toolbar", { name: "Slides" });
  await expect(bar).toContainText("2 of 4");
  const blank = page.getByRole("button", { name: "The screen is blank" });
  for (const key of ["b", "."]) {
    await page.keyboard.press(key);
    await expect(blank).toBeFocused();
    await page.keyboard.press(key);
    await expect(blank).toHaveCount(0);
  }
  await page.keyboard.press("b");
  await page.keyboard.press("Escape");
  await expect(blank).toHaveCount(0);
  await expect(bar).toBeVisible();
  await page.keyboard.press("t");
  const timer = page.getByRole("region", { name: "Timer" });
  await timer.getByLabel("Minutes").fill("7");
  await expect(timer.getByRole("status", { name: "Time left" })).toHaveText("7:00");
  await timer.getByRole("button", { name: "Start" }).click();
  await page.keyboard.press("t");
  await expect(timer.getByRole("button", { name: "Start" })).toBeVisible();
  await expectClean(page);
  await page.keyboard.press("?");
  await expect(page.getByRole("dialog", { name: "Keys of the slides" })).toBeVisible();
  await expectClean(page);
  await page.keyboard.press("Escape");
  await expect(page.getByRole("dialog")).toHaveCount(0);
  await expect(bar).toContainText("2 of 4");
});

test("a handout asks and does not tell, and has its answers on a page of their own", async ({ page }) => {
  await openFigure(page, "e6");
  await page.getByText("A single point", { exact: true }).click();
  await page.getByRole("button", { name: "Show me" }).click();
  await expect(page.getByTestId("truth")).toBeVisible();
  const solutions = page.getByText("Solutions of the exercises");
  const paper = async (event: "beforeprint" | "afterprint") => {
    await page.evaluate((name) => dispatchEvent(new Event(name)), event);
    await page.emulateMedia({ media: event === "beforeprint" ? "print" : null });
  };
  // Whoever prints a copy for a pupil gets no answers with it.
  await paper("beforeprint");
  await expect(page.getByText("Exercise 2", { exact: true })).toBeVisible();
  await expect(solutions).toBeHidden();
  await paper("afterprint");
  // Nor where the page shows them: the browser's own print does not ask.
  await page.getByText("For teachers", { exact: true }).click();
  await paper("beforeprint");
  await expect(solutions).toBeHidden();
  await expect(page.getByRole("img", { name: "QR code of the link", includeHidden: true })).toBeVisible();
  await expect(page.getByText(/#learn\/e6$/)).toBeVisible();
  await paper("afterprint");
  await expect(page.getByText(/#learn\/e6$/)).toHaveCount(0);
  await page.evaluate(() => {
    document.documentElement.dataset["handout"] = "all";
  });
  await paper("beforeprint");
  await expect(page.getByTestId("truth")).toHaveCount(0);
  await expect(page.getByRole("radio", { checked: true })).toHaveCount(0);
  await expect(page.getByRole("button", { name: "A hint" }).first()).toBeHidden();
  await expect(solutions).toBeVisible();
  // What asks for a slider has another exercise in its place.
  await expect(page.getByText(/^Choose the turn/)).toBeHidden();
  await expect(page.getByText(/^A letter is turned by some angle/)).toBeVisible();
  // Nothing is cut at the side, on either paper.
  for (const format of ["A4", "Letter"]) {
    const pdf = (await page.pdf({ format })).toString("latin1");
    expect(pdf.match(/\/Type \/Page\b/g)?.length, format).toBeGreaterThan(1);
  }
  await paper("afterprint");
  await expect(page.getByTestId("truth")).toBeVisible();
  // Answers are no tap away from who learns.
  await expect(solutions).toBeHidden();
  await page.getByRole("button", { name: "Show the answers" }).click();
  await expect(solutions).toBeVisible();
  await paper("beforeprint");
  await expect(solutions).toBeHidden();
  await paper("afterprint");
  // What is printed is chosen, whatever the page shows.
  await page.evaluate(() => {
    window.print = () => {
      document.title = `printed ${document.documentElement.dataset["handout"]}`;
    };
  });
  await page.getByRole("button", { name: "Print a handout" }).click();
  await page.getByRole("menuitem", { name: "Copies for pupils" }).click();
  await expect(page).toHaveTitle("printed copies");
});

test("a sheet goes to a class, and its answers come back as a table", async ({ page }) => {
  await page.goto("./#learn/class");
  await page.getByLabel("Its title").fill("Class 9b");
  await page.getByRole("checkbox", { name: "Two pieces that touch" }).check();
  await page.getByText("Shapes of the gallery").click();
  await page.getByRole("checkbox", { name: "Gasket", exact: true }).check();
  await page.getByRole("textbox", { name: "Gasket", exact: true }).fill("Count its <b>copies</b>");
  // A sheet in the making is there after a reload.
  await page.reload();
  await expect(page.getByLabel("Its title")).toHaveValue("Class 9b");
  await expect(page.getByRole("textbox", { name: "Gasket", exact: true })).toHaveValue(/^Count/);
  await page.getByLabel("Links that you have copied").fill("https://x/#learn/e7/at=question nonsense");
  await expect(page.getByText("One line is left out")).toBeVisible();
  await page.getByLabel("What your class sees link 1 called").fill("Where do they part?");
  await expect(page.getByRole("img", { name: "QR code of the link" })).toBeVisible();
  await expectClean(page);
  await page.getByRole("link", { name: "See it as your class does" }).click();
  await expect(page.getByRole("heading", { level: 1, name: "Class 9b" })).toBeVisible();
  await expectClean(page);
  const save = page.getByRole("button", { name: "Save as a file" });
  // On paper it leads to itself, and has no buttons.
  await expect(page.getByRole("img", { name: "QR code of the link" })).toBeHidden();
  await page.emulateMedia({ media: "print" });
  await expect(page.getByRole("img", { name: "QR code of the link" })).toBeVisible();
  await expect(save).toBeHidden();
  await page.emulateMedia({ media: null });
  await expect(save).toBeDisabled();
  await page.getByLabel("Your name").fill("Ana");
  await page.getByLabel(/What did you find\? .*Two pieces/).fill("They part below 0.4");
  await expect(page.getByText("Count its <b>copies</b>")).toBeVisible();
  await expect(page.getByRole("link", { name: "Where do they part?" })).toBeVisible();
  await page.getByRole("checkbox", { name: "done" }).first().check();
  // What was written is there after a visit elsewhere.
  await page.getByRole("link", { name: /Two pieces that touch/ }).click();
  // At its top and at its end.
  await page.getByRole("link", { name: "Back to the class sheet" }).last().click();
  await expect(page.getByLabel("Your name")).toHaveValue("Ana");
  await page.getByRole("link", { name: "Gasket" }).click();
  await page.getByRole("complementary").getByRole("link", { name: "Back to the class sheet" }).click();
  const [download] = await Promise.all([page.waitForEvent("download"), save.click()]);
  expect(download.suggestedFilename()).toBe("answers-ana.json");
  await expect(page.getByText("Saved as answers-ana.json")).toBeVisible();
  const file = await readFile(await download.path());

  await page.evaluate(() => location.assign("#learn/class"));
  await page.getByLabel("Files of answers").setInputFiles([
    { name: "ana.json", mimeType: "application/json", buffer: file },
    { name: "photo.json", mimeType: "application/json", buffer: Buffer.from("{}") },
  ]);
  const row = page.getByRole("row", { name: /^Ana/ });
  await expect(row).toContainText("They part below 0.4");
  await expect(row).toContainText("done");
  await expect(page.getByText("photo.json: This is no file of answers.")).toBeVisible();
});

test.describe(() => {
  // In the tab that tests share nothing is kept over a reload.
  test.use({ alone: true });

  test("what a class has handed in stays in the teacher's browser, and is saved and printed", async ({
    page,
  }) => {
    const item = { item: "e1", done: true, exercises: [1], answer: "They part below 0.4" };
    const wrong = { ...item, guess: "0.42", right: false, truth: "0.4" };
    const open = { item: "e3", done: false, exercises: [], guess: "", answer: "A line for each" };
    const items = [wrong, open];
    const answers = { kind: "frond answers", version: 1, name: "Ana", title: "Class 9b", items };
    await page.goto("./#learn/class");
    await page.getByLabel("Files of answers").setInputFiles([
      { name: "ana.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(answers)) },
      { name: "photo.json", mimeType: "application/json", buffer: Buffer.from("{}") },
    ]);
    // What could not be read is told once the rest is kept.
    await expect(page.getByText("photo.json: This is no file of answers.")).toBeVisible();
    await page.reload();
    const row = page.getByRole("row", { name: /^Ana/ });
    await expect(row).toContainText("They part below 0.4");
    const [table] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("button", { name: "Save as CSV" }).click(),
    ]);
    expect(table.suggestedFilename()).toBe("answers-class-9b.csv");
    expect(await readFile(await table.path(), "utf8")).toContain('"They part below 0.4"');
    // Right or wrong is said in words, with what is so; what is written is an answer.
    await expect(row).toContainText("wrong");
    await expect(row).toContainText("it is: 0.4");
    await expect(row).not.toContainText("not yet");
    await page.emulateMedia({ media: "print" });
    await expect(row).toBeVisible();
    await expect(page.getByText("Class 9b", { exact: true })).toBeVisible();
    await expect(page.getByRole("heading", { name: "Make a sheet" })).toBeHidden();
    await page.emulateMedia({ media: null });
    await page.getByRole("button", { name: "Clear the table" }).click();
    await expect(row).toHaveCount(0);
    await page.getByRole("button", { name: "Undo" }).click();
    await expect(row).toBeVisible();
  });
});

test("a guess is there again after a way into the studio and back", async ({ page }) => {
  await openFigure(page, "e12");
  const guess = page.getByRole("radio", { name: /^Half of it/ });
  await guess.check();
  await page.getByRole("button", { name: "Show me" }).click();
  await page.getByRole("link", { name: "Open in the studio" }).click();
  await expect(page.getByRole("complementary")).toBeVisible();
  await page.goBack();
  await expect(guess).toBeChecked();
  await expect(page.getByTestId("truth")).toBeVisible();
});
