/**
 * The service worker: after one visit the studio is there without a network. In a window of its own, where requests may
 * fail.
 */
import { expect, test } from "@playwright/test";

test("after a visit the studio works off line, and a page that was not opened says so", async ({
  browser,
  baseURL,
}) => {
  const context = await browser.newContext({ serviceWorkers: "allow" });
  const page = await context.newPage();
  const shown = () => expect(page.getByRole("slider", { name: "Time", exact: true })).toBeVisible();
  await page.goto(`${baseURL}#a=koch&b=gasket&t=0.5`);
  await shown();
  /** What of all that was loaded is not kept yet. */
  const missing = () =>
    page.evaluate(async () => {
      const kept = (await (await caches.open("frond")).keys()).map(({ url }) => url);
      const loaded = [location.href, ...performance.getEntriesByType("resource").map(({ name }) => name)];
      return loaded
        .map((url) => url.replace(/[?#].*/, ""))
        .filter((url) => url.startsWith("http") && !kept.includes(url));
    });
  await expect.poll(missing).toEqual([]);
  await context.setOffline(true);
  await page.reload();
  await shown();
  await expect(page.getByText(/piece|gap seen/).first()).toBeVisible();
  await page.goto(`${baseURL}shape/fern.html`);
  await expect(page.getByText("You are off line")).toBeVisible();
  await page.getByRole("link", { name: "open it" }).click();
  await shown();
  await context.close();
});
