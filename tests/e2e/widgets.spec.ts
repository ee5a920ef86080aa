import { fileURLToPath } from "node:url";
import { createServer } from "vite";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

const root = fileURLToPath(new URL("../..", import.meta.url));

test("every widget is drawn in every state, and stands in the way of nobody", async ({ page }) => {
  // The page of widgets is no part of the built site.
  const server = await createServer({ root, server: { host: "127.0.0.1", port: 0 }, logLevel: "error" });
  try {
    await server.listen();
    await page.goto(`${server.resolvedUrls?.local[0]}www/widgets.html`);
    await expect(page.getByRole("region", { name: "ShapeGrid" })).toBeVisible();
    await page.getByRole("spinbutton", { name: "Refused" }).fill("1/0");
    await page.keyboard.press("Enter");
    await expect(page.getByRole("alert").filter({ hasText: "Still" })).toBeVisible();
    await expectClean(page);
    await page.getByRole("button", { name: "More", exact: true }).click();
    await expect(page.getByRole("menuitem")).toHaveCount(3);
    await page.keyboard.press("Escape");
    for (const name of ["Narrow", "Wide", "Keys"]) {
      await page.getByRole("button", { name, exact: true }).click();
      await expect(page.getByRole("dialog")).toBeVisible();
      await page.keyboard.press("Escape");
    }
    await page.getByRole("button", { name: "Notices" }).click();
    await expect(page.getByRole("region", { name: "Notices" })).toBeVisible();
  } finally {
    await server.close();
  }
});
