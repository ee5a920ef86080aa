import { expectClean } from "./axe";
import { expect, test } from "./fixture";

const LINK = "v=1&a=gasket&b=gasket&path=straight&mode=linear&directed-a=snowflake&directed-b=crystal";

test("a shape of several states is chosen beside a system, morphed, undone and kept by its link", async ({
  studio,
  page,
}) => {
  await studio.open("v=1&a=gasket&b=koch&path=straight");
  const before = await studio.look();
  await page.getByRole("button", { name: /^Shape A: / }).click();
  const shelf = page.getByRole("region", { name: "Shapes of several states" });
  // It is fetched once it is seen, by keys too.
  await shelf.focus();
  await shelf.getByRole("button", { name: /^Snowflake/ }).click();
  await expect(page.getByRole("dialog")).toHaveCount(0);
  const card = page.getByRole("button", { name: /^Shape A: / });
  await expect(card).toHaveAccessibleName(/^Shape A: Snowflake, 2 states, 7 maps/);
  await expect(page.getByRole("button", { name: /^Shape B: / })).toHaveAccessibleName(/4 maps/);
  const flake = await studio.look();
  expect(flake.hash).not.toBe(before.hash);
  await expect(studio.verdict).toContainText("In one piece, proved");
  await page.getByRole("banner").getByRole("button", { name: "Undo" }).click();
  expect((await studio.look()).hash).toBe(before.hash);
});

test("a link of two of them opens with what is proved of the way and of each state", async ({
  studio,
  page,
}) => {
  await studio.open(LINK);
  await expect(page.getByRole("heading", { name: "Shapes of several states" })).toBeVisible();
  await page.getByRole("spinbutton", { name: "Time in percent" }).fill("50");
  await page.keyboard.press("Enter");
  await studio.verdict.click();
  await expect(page.getByRole("heading", { name: "What is known about each state" })).toBeVisible();
  await expect(page.getByRole("listitem").filter({ hasText: /^State 2/ })).toContainText("copies of state 2");
  expect((await studio.scene()).directed?.b.preset).toBe("crystal");
  await page.getByRole("button", { name: "Edit the states of A" }).click();
  await expectClean(page);
  // Nothing bends it, which is said, and it stays.
  await page.getByRole("link", { name: "Deform" }).click();
  await expect(page.getByRole("heading", { name: "This shape is not deformed" })).toBeVisible();
  await page.getByRole("button", { name: "Deform its picture" }).click();
  await expect(page.getByRole("heading", { name: "This shape is not deformed" })).toHaveCount(0);
  expect((await studio.scene()).deform?.subject).toBe("picture");
  await page.getByRole("banner").getByRole("button", { name: "Undo" }).click();
  await page.getByRole("button", { name: "Back to Morph" }).click();
  expect((await studio.scene()).directed?.a.preset).toBe("snowflake");
});

test("where they hold together on the way is drawn, and a press on it goes to the moment", async ({
  studio,
  page,
}) => {
  await studio.open(LINK);
  const map = page.getByRole("region", { name: "Where it stays in one piece" });
  await map.scrollIntoViewIfNeeded();
  await expect(map.getByRole("list", { name: "Legend" })).toContainText("in pieces");
  const square = map.locator(".locus-square");
  const { width, height } = (await square.boundingBox()) ?? { width: 0, height: 0 };
  // (1, 1) in a map from -1 to 2.
  await square.click({ position: { x: (2 / 3) * width, y: height / 3 } });
  await expect(page.getByRole("spinbutton", { name: "Time in percent" })).toHaveValue("100");
  await square.click({ position: { x: width / 2, y: height / 2 } });
  await expect(page.getByRole("spinbutton", { name: "Time in percent" })).toHaveValue("50");
});

test("a fern becomes an outline edge by edge, and its link opens it", async ({ studio, page }) => {
  await studio.open("v=1&curve-a=oak&curve-b=maple");
  await page.getByRole("button", { name: "From a fern to B" }).click();
  await expect(page.getByRole("button", { name: /^Shape A: / })).toHaveAccessibleName(/^Shape A: Frond/);
  await expect(page.getByRole("button", { name: /^Shape B: / })).toHaveAccessibleName(/states/);
  await expect(page.getByText(/parted into \d+ stretches/)).toBeVisible();
  await expect(page.getByText(/in one piece at every moment of the path, proved/)).toBeVisible();
  const fern = await studio.look();
  await page.getByRole("spinbutton", { name: "Time in percent" }).fill("100");
  await page.keyboard.press("Enter");
  const leaf = await studio.look();
  expect(leaf.hash).not.toBe(fern.hash);
  await page.getByRole("button", { name: "More for shape B" }).click();
  await page.getByRole("menuitem", { name: "Save this shape" }).click();
  // It is kept once that is said: another page may be opened then.
  await expect(page.locator(".toasts")).toContainText(/kept|Yours/i);
  const link = new URL(page.url()).hash.slice(1);
  expect(link).toMatch(/directed-a=frond&directed-b=curve:/);
  await studio.open(link);
  expect((await studio.look()).hash).toBe(leaf.hash);
  await page.getByRole("button", { name: /^Shape A: / }).click();
  await page
    .getByRole("region", { name: "Your shapes" })
    .getByRole("button", { name: /^Maple/ })
    .first()
    .click();
  await expect(page.getByRole("button", { name: /^Shape A: / })).toHaveAccessibleName(/^Shape A: Maple/);
});

test("what changes is said aloud", async ({ studio, page }) => {
  await studio.open(LINK.replace("linear", "polar"));
  await expect(studio.verdict).toContainText("In one piece, proved");
  const time = page.getByRole("spinbutton", { name: "Time in percent" });
  const said = page.locator("p[aria-live=polite]");
  // The first is not said; it is the first only once it has been there for a moment.
  await expect(async () => {
    await time.fill("0");
    await time.press("Enter");
    await expect(studio.verdict).toContainText("In one piece, proved");
    await page.waitForTimeout(2000);
    await time.fill("50");
    await time.press("Enter");
    await expect(said).toHaveText("No gap seen, checked to 1/600 of its size", { timeout: 5000 });
  }).toPass();
  await time.fill("0");
  await time.press("Enter");
  await expect(said).toHaveText("In one piece, proved");
});
