/** Following a point on the stage and in lessons, and the game of reaching a cell. */
import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

const panel = (page: Page) => page.getByRole("region", { name: "Follow a point" });
const address = (page: Page) => page.getByTestId("orbit-address");
const words = (page: Page) => page.getByTestId("orbit-words");
const field = (page: Page, name: "x" | "y") =>
  page.getByRole("spinbutton", { name: `Selected point ${name}` });

async function type(page: Page, name: "x" | "y", value: string): Promise<void> {
  await field(page, name).fill(value);
  await field(page, name).press("Enter");
}

test("a point is followed by keys, a press and numbers, and its address is written and said", async ({
  studio,
  page,
}) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.open("a=gasket&b=gasket&path=straight");
  await page.locator("body").press("Shift+O");
  await expect(panel(page)).toBeVisible();
  // Digits colour the picture elsewhere, and here they are maps.
  const { colouring } = await studio.scene();
  for (const key of ["1", "3", "2"]) await page.keyboard.press(key);
  await expect(address(page)).toHaveText("2 3 1 …");
  await expect(words(page)).toHaveText(/^Step 3: map 2, to \(/);
  await expect(page.getByTestId("orbit-spoken")).toHaveText(/^Step 3: map 2.*Address: 2 3 1\.$/);
  expect((await studio.scene()).colouring).toBe(colouring);
  await page.keyboard.press("Backspace");
  await expect(address(page)).toHaveText("3 1 …");
  await panel(page).getByRole("button", { name: "100 throws" }).click();
  await expect(words(page)).toHaveText(/^Step 102: map/);
  // Nothing moves by itself where that is not wanted.
  await expect(panel(page).getByRole("button", { name: "Play" })).toHaveCount(0);
  await panel(page).getByRole("button", { name: "Start over" }).click();

  await type(page, "x", "0.5");
  await type(page, "y", "0");
  await expect(words(page)).toContainText("It is on the shape");
  await panel(page).getByRole("radio", { name: "Address" }).check();
  await panel(page).getByRole("button", { name: "Next digit" }).click();
  await expect(address(page)).toHaveText("1 …");
  await expect(words(page)).toContainText("Pieces 1 and 2 share the point");
  await panel(page).getByRole("button", { name: "Next digit" }).click();
  await expect(address(page)).toHaveText("1 2 …");

  const chosen = page.getByRole("button", { name: /^The selected point/ });
  await chosen.focus();
  await chosen.press("ArrowLeft");
  await expect(field(page, "x")).not.toHaveValue("0.5");
  await expect(address(page)).toHaveText("1 2 …");
  // The middle of the largest hole: no piece has it.
  const stage = await page.locator(".picture").first().boundingBox();
  if (!stage) throw new Error("no stage");
  await type(page, "x", "0.5");
  await type(page, "y", "0.29");
  await expect(words(page)).toContainText("is off the shape");
  await panel(page).getByRole("button", { name: "Use the nearest point of the shape" }).click();
  await expect(words(page)).toContainText("lies in piece");

  await page.getByRole("radio", { name: "Apply maps" }).check();
  const before = (await words(page).textContent()) ?? "";
  await page.mouse.click(stage.x + stage.width / 2, stage.y + stage.height / 3);
  await expect(words(page)).not.toHaveText(before);
  await expect(words(page)).toHaveText(/^The point starts at/);
  await expectClean(page);
  // Nothing of it is in the document.
  await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
  await page.keyboard.press("Escape");
  await expect(panel(page)).toHaveCount(0);
  await expect(page.getByRole("button", { name: "Follow a point" })).toBeFocused();
});

test("a point goes by itself where motion is wanted, and rests when it is told to", async ({
  studio,
  page,
}) => {
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await studio.open("a=gasket&b=gasket&path=straight");
  await page.getByRole("button", { name: "Follow a point" }).click();
  await panel(page).getByRole("button", { name: "Play" }).click();
  await expect(words(page)).toHaveText(/^Step 2: map/);
  await panel(page).getByRole("button", { name: "Pause" }).click();
  const said = (await words(page).textContent()) ?? "";
  await expect(page.getByTestId("orbit-spoken")).toContainText(said);
  await panel(page).getByRole("radio", { name: "Address" }).check();
  await expect(panel(page).getByRole("button", { name: "Play" })).toBeVisible();
});

test("a cell is reached in as few throws as it has letters, and its address is the answer", async ({
  studio,
  page,
}) => {
  await studio.open("a=gasket&b=gasket&path=straight");
  await page.getByRole("button", { name: "Follow a point" }).click();
  await page.getByRole("radio", { name: "Reach a cell" }).check();
  const told = page.getByTestId("orbit-game");
  await expect(told).toHaveText("No throw yet.");
  await page.getByRole("radio", { name: "3", exact: true }).check();
  await panel(page).getByRole("button", { name: "Show a solution" }).click();
  await expect(told).toHaveText(
    /^One solution: (\d), then (\d), then (\d)\. Read backwards, this is the address of the cell: \3 \2 \1\./,
  );
  const way = (await page.getByTestId("orbit-thrown").textContent()) ?? "";
  await panel(page).getByRole("button", { name: "Start over" }).click();
  for (const key of way.split(" ")) await page.keyboard.press(key);
  await expect(told).toHaveText(/^Well done: reached in 3 throws/);
  await expectClean(page);
});

test("what cannot be followed or played is said, with what to do", async ({ studio, page }) => {
  const plain = "v=1&a=gasket&b=gasket&path=straight";
  const game = page.getByRole("radio", { name: "Reach a cell" });
  const start = async (fragment: string) => {
    await studio.open(fragment);
    await page.locator("body").press("Shift+O");
  };
  await test.step("a closed curve has no maps to follow a point by", async () => {
    await start(`${plain}&curve-a=maple&curve-b=oak`);
    await expect(panel(page)).toHaveCount(0);
  });
  await test.step("a bent shape is not where its maps take it", async () => {
    await start(`${plain}&mesh=4x4:0,0,1,1&keys=0:6,0.2,0`);
    await expect(panel(page)).toContainText("Turn off the deformation in Deform");
    await expect(panel(page).getByRole("button", { name: "Throw" })).toHaveCount(0);
  });
  await test.step("a stem that is flat has addresses, and no cells to hit", async () => {
    await start("v=1&a=fern&b=fern&path=straight&t=0");
    await expect(panel(page)).toContainText("Map 1 flattens the shape");
    await expect(game).toBeDisabled();
    await type(page, "x", "0");
    await type(page, "y", "0");
    await panel(page).getByRole("radio", { name: "Address" }).check();
    await panel(page).getByRole("button", { name: "Next digit" }).click();
    await expect(words(page)).toContainText("Map 1 flattens the shape, so it has no inverse");
  });
  await test.step("of many maps one is named by its number", async () => {
    const rows = Array.from({ length: 12 }, (_, i) => `0.08,0,0,0.08,${i},${i % 2}`).join(";");
    await start(`v=1&a=maps:${rows}&b=maps:${rows}&path=straight&t=0`);
    await expect(panel(page)).toContainText("This shape has 12 maps");
    const number = page.getByRole("spinbutton", { name: "Map", exact: true });
    await number.fill("13");
    await number.press("Enter");
    await expect(number).toHaveAttribute("aria-invalid", "true");
    await number.fill("11");
    await number.press("Enter");
    await panel(page).getByRole("button", { name: "Apply map 11" }).click();
    await expect(address(page)).toHaveText("11 …");
  });
  await test.step("one map leads to its own point", async () => {
    await start("v=1&a=maps:0.5,0,0,0.5,1,0&b=maps:0.5,0,0,0.5,1,0&path=straight&t=0");
    await expect(game).toBeDisabled();
    await panel(page).getByRole("button", { name: "100 throws" }).click();
    await expect(words(page)).toHaveText(/^Step 100: map 1, to \(2, 0\)/);
  });
});

test("the link of the lesson has its target, which is reached by keys and by a press", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.goto("./#learn/e31/target=13");
  const picture = page.getByRole("region", { name: "The picture" });
  const told = picture.getByTestId("orbit-game");
  await picture.getByRole("button", { name: "Throw map 3" }).click();
  // The button keeps the focus, and so the keys are still heard.
  await page.keyboard.press("2");
  await page.keyboard.press("Backspace");
  await page.keyboard.press("1");
  await expect(told).toHaveText(
    "Well done: reached in 2 throws, the fewest possible. The cell has the address 1 3. Compare it with your throws.",
  );
  // What is copied holds the target, hidden, and none of the throws.
  await page.getByRole("button", { name: "Copy a link", exact: true }).click();
  await expect(page.getByText(/^Link copied\./)).toBeVisible();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toMatch(/#learn\/e31\/target=[a-z]{2}$/);
  await page.goto("about:blank");
  await page.goto(copied);
  await expect(told).toHaveText("No throw yet.");
  await picture.getByRole("button", { name: "Show a solution" }).click();
  await expect(told).toHaveText(
    "One solution: 3, then 1. Read backwards, this is the address of the cell: 1 3.",
  );
  await picture.getByRole("button", { name: "Start over" }).click();
  const box = await picture.getByRole("img").boundingBox();
  if (!box) throw new Error("no picture");
  await page.mouse.click(box.x + 0.7 * box.width, box.y + 0.85 * box.height);
  await expect(picture.getByTestId("orbit-thrown")).toHaveText("2");
  await picture.getByRole("radio", { name: "5" }).check();
  await expect(told).toHaveText("No throw yet.");
  await picture.getByRole("button", { name: "Show a solution" }).click();
  await expect(told).toHaveText(/^One solution: (?:\d, then ){4}\d\./);
});

test("the boards of the lesson are played by keys alone, and the focus stays where they are heard", async ({
  page,
}) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./#learn/e31/target=13");
  const picture = page.getByRole("region", { name: "The picture" });
  const thrown = picture.getByTestId("orbit-thrown");
  const spoken = picture.getByTestId("orbit-spoken");
  const first = picture.getByRole("button", { name: "Throw map 1" });
  await test.step("the first board hears keys while nothing else does", async () => {
    await expect(spoken).toHaveText(
      "The framed cell is 0.25 wide, with its centre at (0.25, 0.289). No throw yet. The point is at (0.5, 0.289).",
    );
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur());
    await page.keyboard.press("2");
    await expect(thrown).toHaveText("2");
    await page.getByRole("heading", { level: 1 }).focus();
    await page.keyboard.press("3");
    await expect(thrown).toHaveText("2 3");
    await expect(spoken).toHaveText(
      "2 throws. The point is not in the framed cell yet. The point is at (0.625, 0.505). The centre of the cell is at (0.25, 0.289).",
    );
    await expect(picture.getByRole("img")).toHaveAccessibleName(/a triangle 1 wide, .* \(0\.625, 0\.505\)/);
  });
  await test.step("what rests once nothing is thrown hands its focus on", async () => {
    const again = picture.getByRole("button", { name: "Start over" });
    await again.focus();
    await page.keyboard.press("Enter");
    await expect(again).toBeDisabled();
    await expect(first).toBeFocused();
    await page.keyboard.press("3");
    await picture.getByRole("button", { name: "Back" }).focus();
    await page.keyboard.press("Backspace");
    await expect(first).toBeFocused();
    const before = (await spoken.textContent()) ?? "";
    await picture.getByRole("button", { name: "New target" }).press("Enter");
    await expect(spoken).not.toHaveText(before);
    await expect(spoken).toHaveText(/^The framed cell is 0\.25 wide, with its centre at \(/);
  });
  await test.step("each exercise hears its own keys", async () => {
    const [reach, read] = [1, 2].map((n) => page.getByTestId("exercise").nth(n - 1));
    if (!reach || !read) throw new Error("no exercises");
    await reach.getByRole("button", { name: "Throw towards 1" }).focus();
    for (const key of ["1", "2", "2"]) await page.keyboard.press(key);
    await expect(reach).toContainText("Thrown: 1 2 2");
    const clear = reach.getByRole("button", { name: "Clear" });
    await clear.focus();
    await page.keyboard.press("Enter");
    await expect(reach.getByRole("button", { name: "Throw towards 1" })).toBeFocused();
    for (const key of ["1", "2", "1", "3", "3"]) await page.keyboard.press(key);
    await expect(reach).toContainText("Thrown: 1 2 1 3");
    await expect(reach).toContainText("Solved.");
    await read.getByRole("button", { name: "The point is in piece 2" }).focus();
    for (const key of ["2", "3", "Backspace"]) await page.keyboard.press(key);
    await expect(read.getByText("Address: 2", { exact: true })).toBeVisible();
    await expect(thrown).toHaveText("nothing yet");
  });
});
