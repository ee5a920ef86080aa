import type { Page } from "@playwright/test";
import type { Graph } from "../../crate/web/src/api";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";
import type { Studio } from "./studio";

const GRAPH = "v=1&a=gasket&b=gasket&path=straight&tool=fit&fit=graph:closed,260,0";

async function open(page: Page, more = ""): Promise<void> {
  await openLink(page, `${GRAPH}${more}`);
}

/** There is no time here, which the studio would wait for. */
async function openLink(page: Page, link: string): Promise<void> {
  if (page.url() !== "about:blank") await page.goto("about:blank");
  await page.goto(`./#${link}`);
  await expect(page.getByRole("application", { name: /^The graph\./ })).toBeVisible({ timeout: 60_000 });
}

const point = (page: Page, number: number) =>
  page.getByRole("button", { name: new RegExp(`^Point ${number} at t`) });

const undo = (page: Page) => page.getByRole("button", { name: "Undo" });

async function graph(studio: Studio): Promise<Graph | undefined> {
  return (await studio.scene()).fit?.graph;
}

/** Where the first piece ends, and the height there: T of the right end of what it copies. */
async function middle(studio: Studio): Promise<[number, number]> {
  const piece = (await graph(studio))?.pieces[0];
  if (!piece) throw new Error("there is no graph");
  const [a, b, , d, e] = piece.map;
  // The graph of Figure 1 is 0 at both ends.
  return [a * piece.domain[1] + d, b * piece.domain[1] + e];
}

async function search(page: Page, example: string): Promise<void> {
  await page.getByLabel("An example").selectOption(example);
  await page.getByRole("button", { name: "Find the maps" }).click();
  await expect(page.locator("[data-part=took]")).toBeVisible({ timeout: 90_000 });
}

test("a point follows the mouse and the keys, a drag is one undo step, and numbers say where it is", async ({
  studio,
  page,
}) => {
  await open(page);
  expect(await graph(studio)).toBeUndefined();
  const box = await point(page, 2).locator(".knob").boundingBox();
  if (!box) throw new Error("there is no point 2");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 60, y + 40, { steps: 4 });
  await page.mouse.move(x - 100, y + 80, { steps: 4 });
  await page.mouse.up();
  const [t, height] = await middle(studio);
  expect(t).toBeLessThan(0.47);
  expect(height).toBeLessThan(0.95);
  const shown = await page.getByRole("spinbutton", { name: "Height of point 2" }).inputValue();
  expect(Number(shown)).toBeCloseTo(height, 3);

  await point(page, 2).focus();
  await page.keyboard.press("ArrowUp");
  const [sameT, higher] = await middle(studio);
  expect(sameT).toBeCloseTo(t, 9);
  expect(higher).toBeGreaterThan(height);
  await page.keyboard.press("Shift+ArrowRight");
  expect((await middle(studio))[0]).toBeGreaterThan(t);
  await undo(page).click();
  await undo(page).click();
  expect((await middle(studio))[1]).toBeCloseTo(height, 9);
  await undo(page).click();
  expect(await graph(studio)).toBeUndefined();
});

test("roughness is turned by keys, pieces are mirrored, and kinds tell what is copied", async ({
  studio,
  page,
}) => {
  await open(page);
  const rough = page.getByRole("slider", { name: "Roughness of piece 1" });
  await rough.focus();
  await page.keyboard.press("ArrowRight");
  expect((await graph(studio))?.pieces[0]?.map[2]).toBeCloseTo(0.61, 9);
  // Too much is refused with a sentence, and the last good value stays.
  const field = page.getByRole("spinbutton", { name: "Roughness of piece 1" });
  await field.fill("1.5");
  await page.keyboard.press("Enter");
  await expect(page.getByText(/Enter at most 0.99/)).toBeVisible();
  expect((await graph(studio))?.pieces[0]?.map[2]).toBeCloseTo(0.61, 9);
  await page.keyboard.press("Escape");
  await page.getByRole("switch", { name: "Mirrored", exact: true }).check({ force: true });
  expect((await graph(studio))?.pieces[0]?.map[0]).toBeCloseTo(-0.5, 9);
  await page.getByRole("radio", { name: "Any part" }).check({ force: true });
  const from = page.getByRole("spinbutton", { name: /^copies from/ });
  await from.fill("0.2");
  await page.keyboard.press("Enter");
  expect((await graph(studio))?.kind).toBe("pfif");
  expect((await graph(studio))?.pieces[0]?.domain).toEqual([0.2, 1]);
  await page.getByRole("button", { name: "Point", exact: true }).click();
  expect((await graph(studio))?.pieces).toHaveLength(3);
});

test("the two maps of Table 1 are found, picked by key, and put together; a link brings them back", async ({
  studio,
  page,
}) => {
  await open(page);
  await search(page, "table1");
  const list = page.getByRole("list", { name: "Candidates, most hits first" });
  await expect(list.getByRole("button", { name: /^Map [12]/ })).toHaveCount(2);
  await expect(list.getByRole("button", { name: /^Echo/ }).first()).toBeVisible();
  const clusters = page.getByRole("listbox");
  await clusters.focus();
  await page.keyboard.press("Home");
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Assemble 2 selected maps" }).click();
  await expect(page.locator("[data-part=assembled]")).toContainText("FIF of 2 pieces");
  await page.getByRole("button", { name: "Assemble", exact: true }).click();
  await expect(page.locator("[data-part=assembled]")).toContainText("FIF of 2 pieces");
  const found = await graph(studio);
  for (const [i, map] of [
    [0.5, 0.746, 0.5, -0.5, 0.246],
    [0.5, -0.199, -0.6, 0.5, 0.189],
  ].entries()) {
    for (const [j, x] of map.entries()) expect(found?.pieces[i]?.map[j]).toBeCloseTo(x, 1);
  }

  await expect.poll(() => page.url()).toContain("graph=fif");
  const link = new URL(page.url()).hash.slice(1);
  await openLink(page, link);
  expect(await graph(studio)).toEqual(found);
});

test("what is put together keeps a tolerance, and says what a polyline as near takes", async ({ page }) => {
  await open(page);
  await search(page, "table1");
  const field = page.getByRole("spinbutton", { name: /^Maximum error/ });
  await field.fill("5");
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Assemble", exact: true }).click();
  const words = page.locator("[data-part=assembled]");
  await expect(words).toContainText(/It takes \d+ numbers; a polyline of the same accuracy takes \d+\./);
  await expect(words).not.toContainText("e-");
});

test("a search is stopped at once, and what was there stays", async ({ page }) => {
  await open(page);
  await search(page, "table1");
  await page.getByRole("button", { name: "Find the maps" }).click();
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await expect(page.getByRole("button", { name: "Find the maps" })).toBeVisible();
  await expect(page.getByRole("list", { name: "Candidates, most hits first" })).toBeVisible();
  // It can be begun again.
  await page.getByRole("button", { name: "Find the maps" }).click();
  await expect(page.locator("[data-part=took]")).toBeVisible({ timeout: 90_000 });
});

test("the seven maps of Table 3 come to eleven pieces from point to point", async ({ studio, page }) => {
  await open(page);
  await search(page, "hidden");
  await page.getByRole("button", { name: "Select those of Table 3 (7 of 7 found)" }).click();
  await page.getByRole("switch", { name: "Close gaps between pieces" }).uncheck({ force: true });
  await page.getByRole("button", { name: "Assemble 7 selected maps" }).click();
  await expect(page.locator("[data-part=assembled]")).toContainText("PFIF of 7 pieces");
  await page.getByRole("radio", { name: "A stretch" }).check({ force: true });
  const now = await graph(studio);
  expect(now?.kind).toBe("rfif");
  const starts = now?.pieces.map(({ map: [a, , , d], domain }) => {
    // Nothing below zero: not even a zero.
    return Math.abs(Math.round(54 * (a * domain[a < 0 ? 1 : 0] + d)));
  });
  expect(starts).toEqual([0, 7, 9, 13, 15, 18, 24, 27, 36, 41, 47]);
});

test("a table of numbers is read, a bad one is told about, and nothing is lost", async ({ page }) => {
  await open(page);
  const find = page.getByRole("region", { name: "Find the maps of a series" });
  const input = find.locator("input[type=file]");
  const rows = Array.from({ length: 129 }, (_, i) => `${2000 + i / 8},${Math.abs(((i * 37) % 64) - 32)}`);
  await input.setInputFiles({
    name: "rain.csv",
    mimeType: "text/csv",
    buffer: Buffer.from(`year,rain\n${rows.join("\n")}\n`),
  });
  await expect(find).toContainText("129 points");
  await input.setInputFiles({
    name: "bad.csv",
    mimeType: "text/csv",
    buffer: Buffer.from("name,colour\none,red\ntwo,blue\nthree,green\n"),
  });
  await expect(find.getByRole("alert")).toBeVisible();
  await expect(find).toContainText("129 points");
});

test("it is clean to those who hear it, and zooms along t by keys", async ({ page }) => {
  await open(page);
  await search(page, "table1");
  await expectClean(page);
  const stage = page.getByRole("application", { name: /^The graph\./ });
  await stage.focus();
  for (let i = 0; i < 4; i++) await page.keyboard.press("+");
  const zoom = page.getByRole("button", { name: "Zoom out" }).locator("..");
  await expect(zoom).toContainText("2.4×");
  await page.keyboard.press("0");
  await expect(zoom).not.toContainText("×");
});
