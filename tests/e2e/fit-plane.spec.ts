import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

const CURVE = "v=1&a=gasket&b=gasket&path=straight&tool=fit&fit=plane:closed,260,0";

/** There is no time here, which the studio would wait for. */
async function open(page: Page, more = ""): Promise<void> {
  if (page.url() !== "about:blank") await page.goto("about:blank");
  await page.goto(`./#${CURVE}${more}`);
  await expect(page.getByRole("application", { name: /^The curve\./ })).toBeVisible({ timeout: 60_000 });
}

const point = (page: Page, number: number) =>
  page.getByRole("button", { name: new RegExp(`^Point ${number} at x`) });

test("a curve of the plane is dragged, leaned, refused where it would not shrink, kept and used", async ({
  studio,
  page,
}) => {
  await open(page);
  const word = async () => (await studio.scene()).fit?.plane ?? "";
  expect(await word()).toBe("");
  // Koch's curve: a point goes left of the one before it.
  const box = await point(page, 3).locator(".knob").boundingBox();
  if (!box) throw new Error("there is no point 3");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 60, y - 20, { steps: 4 });
  await page.mouse.move(x - 150, y - 40, { steps: 4 });
  await page.mouse.up();
  const dragged = await word();
  const places = dragged.split(":")[0]?.split(";") ?? [];
  expect(places).toHaveLength(5);
  expect(Number(places[2]?.split(",")[1])).toBeLessThan(0.34);
  await expect(page.getByText("attractor of 4 maps", { exact: false })).toBeVisible();
  // A factor by keys: it leans, and is refused with its reason where it would lengthen.
  const arrow = page.getByRole("button", { name: /^Piece 1 takes x/ });
  await arrow.focus();
  await page.keyboard.press("ArrowUp");
  const leaning = await word();
  expect(leaning).not.toBe(dragged);
  await expect(page.getByText("Its maps need t", { exact: false })).toBeVisible();
  for (let i = 0; i < 24; i++) await page.keyboard.press("ArrowUp");
  await expect(page.getByRole("alert").filter({ hasText: "times as long" })).toBeVisible();
  const last = await word();
  // The link opens it elsewhere.
  const hash = () => page.evaluate(() => location.hash);
  await expect.poll(hash).toContain(`plane=${last}`);
  const link = await hash();
  await page.goto("about:blank");
  await page.goto(`./${link}`);
  await expect(page.getByRole("application", { name: /^The curve\./ })).toBeVisible({ timeout: 60_000 });
  expect(await word()).toBe(last);
  await expectClean(page);
  await page.getByRole("button", { name: "Use as A" }).click();
  await expect.poll(async () => (await studio.scene()).curves?.a.name).toBe("Curve of the plane");
});

test("a graph becomes a curve of the plane, and a damaged curve is told", async ({ studio, page }) => {
  await page.goto("./#v=1&a=gasket&b=gasket&path=straight&tool=fit&fit=graph:closed,260,0");
  await page.getByRole("button", { name: "As a curve of the plane" }).click({ timeout: 60_000 });
  await expect(page.getByRole("application", { name: /^The curve\./ })).toBeVisible();
  expect((await studio.scene()).fit?.plane).toBe("0,0,0;0.5,0.5,1;1,1,0:0,0,0,0.6,0,2;0,0,0,0.4,0,2");
  await open(page, "&plane=0,0,0;1,1");
  await expect(page.getByRole("alert").filter({ hasText: "damaged" })).toBeVisible();
});
