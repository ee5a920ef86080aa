import { expect, test } from "./fixture";

test("a path is proved end to end, until it changes", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket&path=drawn:0.5,0.5");
  await studio.idle();
  await page.getByRole("button", { name: "Try to prove the whole path" }).click();
  await expect(
    page.getByText(/Proved in [\d,]+ steps?: no moment|moment of this path, in [\d,]+ steps?\./),
  ).toBeVisible();
  await studio.way(1).focus();
  await page.keyboard.press("ArrowRight");
  await expect(page.getByRole("button", { name: "Try to prove the whole path" })).toBeVisible();
});

test("a waypoint says where the path breaks, and takes a third number", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=drawn:0.6,0.5");
  await studio.idle();
  await studio.way(1).focus();
  await expect(page.locator(".way-point legend")).toHaveText(
    /Waypoint 1 of 1 in pieces, gap [\d.]+%, by Frond’s own bounds, breaks on the path before it/,
  );
  const w = page.getByRole("spinbutton", { name: "stretch lead, w" });
  await expect(w).toHaveCount(0);
  await page.locator(".way-tools").getByText("w", { exact: true }).click();
  await w.fill("0.25");
  await w.press("Enter");
  expect((await studio.scene()).path.points).toEqual([[0.6, 0.5, 0.25]]);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  expect((await studio.scene()).path.points).toEqual([[0.6, 0.5]]);
});

test("another way to match is one step", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket");
  await studio.idle();
  const before = await studio.scene();
  await page.getByText("Which map becomes which").click();
  await page.getByText("Other pairings").click();
  const ways = page.getByRole("radiogroup", { name: "Pairings" }).getByRole("radio");
  await expect(page.getByText(/^Best first/)).toBeVisible();
  expect(await ways.count()).toBeGreaterThan(1);
  await expect(ways.first()).toHaveAccessibleName(/: (no gap seen anywhere|gap [\d.]+%)$/);
  // Links of before have the half turn of map 2 counter-clockwise.
  const own = { name: /^each keeps its number; one turns differently: /, checked: true };
  await expect(page.getByRole("radio", own)).toHaveCount(1);
  await page
    .getByRole("radio", { name: /becomes/ })
    .first()
    .check();
  const after = await studio.scene();
  expect(after.correspondence.length).toBe(3);
  expect(after.path.kind).toBe("auto");
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  // The path is automatic, and found anew.
  expect(await studio.scene()).toMatchObject({
    correspondence: before.correspondence,
    turns: before.turns,
    path: { kind: "auto" },
  });
});

test("shapes that reflect oppositely have ways across", async ({ studio, page }) => {
  await studio.open("a=fern&b=maple");
  const before = await studio.scene();
  await page.locator(".notes").getByRole("button", { name: "Other paths" }).click();
  const ways = page.getByRole("radiogroup", { name: "Paths" }).getByRole("radio");
  await expect(ways.first()).toBeAttached();
  // What happens if nothing is chosen comes first.
  await expect(ways.first()).toBeChecked();
  await ways.nth(1).check();
  const after = await studio.scene();
  expect([after.a.name, after.b.name]).toEqual([before.a.name, before.b.name]);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  const { a, b, correspondence } = await studio.scene();
  expect({ a, b, correspondence }).toEqual({
    a: before.a,
    b: before.b,
    correspondence: before.correspondence,
  });
});

test("where the plane has no path, the third parameter has one", async ({ studio, page }) => {
  await studio.open("a=gasket&b=terdragon-mirrored");
  await studio.idle();
  const words = page.locator(".path-verdict");
  await expect(words).toHaveText(/^In pieces between /);
  await expect(page.locator(".worst-mark")).toBeAttached();
  const third = page.getByRole("switch", { name: /third parameter/ });
  await third.check();
  await expect(words).toHaveText(/anywhere on the path\.|along the whole path\.|sampled moments?\./);
  const { points } = (await studio.scene()).path;
  expect(points.some(([, , w = 0]) => w !== 0)).toBe(true);
  await third.uncheck();
  await expect(words).toHaveText(/^In pieces between /);
});
