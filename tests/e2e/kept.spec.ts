import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";
import type { Studio } from "./studio";

test.use({ alone: true });

const GO_ON = /Continue with/;

/** Draws a path, and waits until it is kept. */
async function make(studio: Studio, page: Page): Promise<void> {
  await page.getByRole("radio", { name: "Drawn" }).check();
  await page.getByRole("button", { name: "Add waypoint" }).click();
  await expect(page).toHaveURL(/#/);
  await studio.idle();
  await expect.poll(() => page.evaluate(() => sessionStorage.getItem("frond.kept"))).not.toBeNull();
}

const openRecent = async (page: Page) => {
  await page.getByRole("button", { name: "Recent", exact: true }).click();
  return page.getByRole("dialog", { name: "Recent" });
};

test("a bare address offers what was made, a first visit and a link do not", async ({ studio, page }) => {
  await studio.open();
  await studio.idle();
  await expect(studio.toasts).not.toContainText(GO_ON);
  await make(studio, page);
  const made = (await studio.scene()).path;

  await studio.open("a=levy&b=twindragon");
  await studio.idle();
  await expect(studio.toasts).not.toContainText(GO_ON);
  await page.getByRole("radio", { name: "Drawn" }).check();
  await page.getByRole("button", { name: "Add waypoint" }).click();
  const list = await openRecent(page);
  await expect(list.getByRole("listitem")).toHaveCount(2);
  await list
    .getByRole("listitem")
    .nth(1)
    .getByRole("button", { name: /^Open / })
    .click();
  await expect.poll(async () => (await studio.scene()).path).toEqual(made);

  await studio.open();
  await expect(studio.toasts).toContainText("Continue with Lévy curve to Twin-dragon?");
  await studio.toasts.getByRole("button", { name: "Continue" }).click();
  await expect.poll(async () => (await studio.scene()).a.preset).toBe("levy");
  await expect(studio.toasts).not.toContainText(GO_ON);
});

test("a reload goes on with the same document", async ({ studio, page }) => {
  await studio.open();
  await make(studio, page);
  await page.reload();
  await studio.time.waitFor();
  await studio.idle();
  await expect(studio.toasts).not.toContainText(GO_ON);
  await page.getByRole("button", { name: "Add waypoint" }).click();
  const list = await openRecent(page);
  await expect(list.getByRole("listitem")).toHaveCount(1);
});

test("what is kept can be named, pinned, removed and cleared by the keyboard", async ({ studio, page }) => {
  await studio.open();
  await make(studio, page);
  const list = await openRecent(page);
  await list.getByRole("button", { name: /^Rename/ }).press("Enter");
  await list.getByRole("textbox").fill("My way");
  await list.getByRole("textbox").press("Enter");
  await expect(list.getByRole("listitem")).toContainText("My way");
  await list.getByRole("button", { name: "Pin My way" }).press("Enter");
  await expect(list.getByRole("listitem")).toContainText("pinned");
  await expectClean(page, "dialog");
  await list.getByRole("button", { name: "Clear all" }).press("Enter");
  await list.getByRole("button", { name: "Remove all 1" }).press("Enter");
  await expect(list).toContainText("Nothing yet.");
});

test("without a store the page says so once, and works", async ({ studio, page }) => {
  await page.addInitScript(() => Object.defineProperty(window, "indexedDB", { value: undefined }));
  await studio.open();
  await page.getByRole("radio", { name: "Drawn" }).check();
  await page.getByRole("button", { name: "Add waypoint" }).click();
  await expect(studio.toasts).toContainText("Your work is not being saved.");
  await expect(page).toHaveURL(/path=/);
});
