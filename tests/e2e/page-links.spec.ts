/** Addresses of pages that are set to something. */
import { expect, test } from "./fixture";

test("a link to a step of a lesson opens it as it was, and is copied again", async ({ page }) => {
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  const state = "at=question&guess=0.31&shown=1&way=0.2,0.85";
  await page.goto(`./#learn/e7/${state}`);
  const question = page.getByRole("region", { name: "What do you think?" });
  await expect(question).toBeFocused();
  await expect(question.getByTestId("truth")).toContainText("You said t = 0.31.");
  await expect(question.getByRole("slider", { name: "Waypoint v, move" })).toHaveValue("0.85");

  await question.getByRole("slider", { name: "Waypoint v, move" }).press("ArrowRight");
  await question.getByRole("button", { name: "Copy a link to this step" }).click();
  await expect(page.getByText("Link copied.")).toBeVisible();
  const copied = new URL(await page.evaluate(() => navigator.clipboard.readText())).hash;
  expect(new Set(copied.replace("#learn/e7/", "").split("&"))).toEqual(
    new Set(state.replace("0.85", "0.9").split("&")),
  );

  // Another link to the same page is followed, too; what cannot be read of it is said.
  await page.evaluate(() => location.assign("#learn/e7/guess=7"));
  await expect(page.getByText("Part of this link could not be read")).toBeVisible();
  await expect(page.getByTestId("truth")).toHaveCount(0);
  await expect(page.getByRole("button", { name: "Show me" })).toBeDisabled();
});

test("a figure opens as its link has it, and what a link should not have is left out", async ({ page }) => {
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.goto("./#figures/7/dragon=terdragon&point=0.25,1.5");
  await expect(page.getByRole("radio", { name: "Terdragon" })).toBeChecked();
  const u = page.getByRole("slider", { name: "u, turn and stretch" });
  await expect(u).toHaveValue("0.25");
  await u.press("ArrowRight");
  await page.getByRole("button", { name: "Copy a link" }).click();
  await expect(page.getByText("Link copied.")).toBeVisible();
  const copied = new URL(await page.evaluate(() => navigator.clipboard.readText())).hash;
  expect(copied).toMatch(
    /^#figures\/7\/(dragon=terdragon&point=0\.2\d+,1\.5|point=0\.2\d+,1\.5&dragon=terdragon)$/,
  );
  expect(copied).not.toContain("0.25,");

  await page.evaluate(() => location.assign("#figures/s34/shape=%3Cb%3E&turn=1e9&x=0.5"));
  await expect(page.getByText("Part of this link could not be read")).toBeVisible();
  await expect(page.getByRole("radio", { name: "Fern" })).toBeChecked();
  await expect(page.getByRole("slider", { name: "Turned" })).toHaveValue("40");
  await expect(page.getByRole("slider", { name: "Moved along x" })).toHaveValue("0.5");
});
