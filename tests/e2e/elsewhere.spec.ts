/** "Use it elsewhere": each of its ways runs, of the very text that is shown (`tests/api/site.test.ts`). */
import type { Locator } from "@playwright/test";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

/** How many pixels of a canvas are of a shape, in a shadow or not. */
const lit = (place: Locator) =>
  place
    .locator("canvas")
    .first()
    .evaluate((canvas: HTMLCanvasElement) => {
      const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
      return data.filter((byte, i) => i % 4 === 3 && byte > 0).length;
    });

// Each frame asks for WebGPU once.
test.use({ expected: /No available adapters/ });

test("every way into other pages is at work, and what is shown is what runs", async ({ page }) => {
  await page.goto("./elsewhere.html");
  const live = (title: string) => {
    const heading = page.getByRole("heading", { name: title, exact: true });
    return page.locator(".live").and(heading.locator("xpath=following-sibling::div[1]"));
  };
  const seen = async (place: Locator) => {
    await place.scrollIntoViewIfNeeded();
    await expect.poll(() => lit(place)).toBeGreaterThan(1000);
  };
  await seen(live("A shape on a page"));
  await seen(live("A morph with a slider, that says whether it holds together"));
  await expect(live("A morph with a slider, that says whether it holds together")).toContainText(
    "In one piece",
  );
  const lesson = live("A lesson, a figure or another tool");
  await lesson.scrollIntoViewIfNeeded();
  await expect(lesson.frameLocator("iframe").getByRole("heading", { level: 1 })).toContainText("touch");

  for (const title of ["Where no script is allowed: a frame", "In slides", "In a Jupyter notebook"]) {
    await live(title).scrollIntoViewIfNeeded();
    await expect(
      live(title).frameLocator("iframe").first().getByRole("slider", { name: "Time" }),
    ).toBeVisible();
  }
  await page.getByText("The background, playing").click();
  const background = live("In slides").frameLocator("details iframe");
  await expect(background.getByRole("link", { name: "Open in Frond" })).toBeVisible();
  await expect(background.getByRole("slider")).toHaveCount(0);
  await page.getByText("The background, playing").click();

  const react = live("In React");
  await seen(react);
  await expect(react.locator("output")).not.toBeEmpty();
  await react.getByRole("slider").press("End");
  await expect(react.locator("output")).toHaveText("In one piece, proved");

  const observable = live("In Observable");
  await seen(observable);
  const moment = () =>
    observable.locator("frond-view").evaluate((view) => (view as HTMLElement & { t: number }).t);
  expect(await moment()).toBe(0.5);
  await observable.getByRole("slider").press("End");
  expect(await moment()).toBe(1);

  await seen(live("Without an element: ten lines"));
  await expectClean(page);
});
