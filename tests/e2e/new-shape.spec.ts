import type { Locator, Page } from "@playwright/test";
import { expect, test } from "./fixture";

const middleOf = async (what: Locator) => {
  const box = await what.boundingBox();
  if (!box) throw new Error("nothing to take hold of");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
};
const drag = async (page: Page, from: { x: number; y: number }, dx: number, dy: number) => {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + dx / 2, from.y + dy / 2, { steps: 3 });
  await page.mouse.move(from.x + dx, from.y + dy, { steps: 3 });
  await page.mouse.up();
};

test("a shape is begun with copies of a square, which stay where they are while others are moved", async ({
  studio,
  page,
}) => {
  await studio.open("a=dragon&b=gasket&path=straight");
  await page.locator("body").press("g");
  await page.getByRole("dialog").getByRole("button", { name: "2 copies", exact: true }).click();
  await expect(page.getByRole("heading", { name: "Maps of A" })).toBeVisible();
  expect((await studio.scene()).a).toEqual({
    name: "New shape",
    maps: [
      [0.5, 0, 0, 0.5, 0, 0],
      [0.5, 0, 0, 0.5, 0.5, 0],
    ],
  });

  await page.getByRole("button", { name: "Add a map" }).click();
  const body = (map: number) =>
    page
      .locator(".overlay")
      .getByRole("button", { name: new RegExp(`^Map ${map}[;,:]?( |$|.*arrow keys move it)`) })
      .first();
  const outline = (map: number) => body(map).getAttribute("d");
  expect((await studio.scene()).a.maps).toHaveLength(3);
  const before = [await outline(1), await outline(2)];
  await drag(page, await middleOf(body(3)), -60, 220);
  expect((await studio.scene()).a.maps[2]).not.toEqual([0.5, 0, 0, 0.5, 0, 0.5]);
  // Neither the frame nor the view has moved.
  expect([await outline(1), await outline(2)]).toEqual(before);

  await page.getByText("Frame of the outlines").click();
  await page.getByRole("button", { name: "Around the shape" }).click();
  expect([await outline(1), await outline(2)]).not.toEqual(before);
  await page.getByRole("button", { name: "Unit square" }).click();

  const count = async () => (await studio.scene()).a.maps.length;
  await page.locator("body").press("Delete");
  await expect.poll(count).toBe(2);
  // The same key again takes away no other: none is chosen.
  await page.locator("body").press("Delete");
  await expect(page.locator(".toasts")).toContainText("Map 3 is removed.");
  expect(await count()).toBe(2);
  // What has the focus is what goes, on the picture and in the list; and nothing while something else has it.
  await body(1).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Delete");
  await expect.poll(count).toBe(1);
  expect((await studio.scene()).a.maps[0]?.[4]).toBe(0.5);
  await page.getByRole("button", { name: "Play" }).focus();
  await page.keyboard.press("Delete");
  await page.locator(".side ol button").first().focus();
  await page.keyboard.press("Delete");
  await expect(page.locator(".toasts")).toContainText("A shape needs at least one");
  // Two maps never lie on each other, and where they differ their numbers do.
  await page.getByRole("button", { name: "Add a map" }).click();
  const [p, q] = (await studio.scene()).a.maps;
  expect(Math.hypot((p?.[4] ?? 0) - (q?.[4] ?? 0), (p?.[5] ?? 0) - (q?.[5] ?? 0))).toBeGreaterThan(0.4);
});

test("Back leaves a dialog and the editor, and then leads to the shape before", async ({ studio, page }) => {
  await studio.open("a=dragon&b=gasket&path=straight&t=0.4");
  const first = async () => (await studio.scene()).a.name;
  await page.locator("body").press("g");
  await page.getByRole("dialog").getByRole("button", { name: "3 copies", exact: true }).click();
  await expect(page.getByRole("heading", { name: "Maps of A" })).toBeVisible();
  await page.locator("body").press("x");
  await page.getByRole("dialog", { name: "Export" }).waitFor();
  await page.goBack();
  await expect(page.getByRole("dialog")).toHaveCount(0);
  await expect(page.getByRole("heading", { name: "Maps of A" })).toBeVisible();
  await page.goBack();
  await expect(page.getByRole("heading", { name: "Maps of A" })).toHaveCount(0);
  expect(await first()).toBe("New shape");
  // The stage shows what was edited.
  expect((await studio.scene()).t).toBe(0);
  await page.goBack();
  await expect.poll(first).toBe("Dragon");
  await page.goForward();
  await expect.poll(first).toBe("New shape");
});

test("a handle of the chosen map takes the drag where the number of another lies on it", async ({
  studio,
  page,
}) => {
  // The upper right corner of the first map is the middle of the second.
  await studio.open("a=gasket&b=gasket&path=straight");
  await page.locator("body").press("e");
  await page.getByRole("radio", { name: "Six numbers" }).check();
  const put = async (map: number, e: string, f: string) => {
    const head = page.locator(".side").getByRole("button", { name: new RegExp(`Map ${map}: `) });
    if ((await head.getAttribute("aria-expanded")) === "false") await head.click();
    for (const [name, value] of [
      ["Move across, e", e],
      ["Move up, f", f],
    ] as const) {
      await page.getByRole("spinbutton", { name }).fill(value);
      await page.getByRole("spinbutton", { name }).press("Enter");
    }
  };
  await put(2, "0.25", "√3/8");
  await put(1, "0", "0");
  const { maps } = (await studio.scene()).a;
  await drag(page, await middleOf(page.getByRole("button", { name: /^Map 1, turns and scales it/ })), 50, 0);
  const after = (await studio.scene()).a.maps;
  expect(after[0]).not.toEqual(maps[0]);
  expect(after.slice(1)).toEqual(maps.slice(1));
});

test("a map has the colour on its number, in the editor and on the stage, that it has in the morph", async ({
  studio,
  page,
}) => {
  await studio.open("a=gasket&b=terdragon&match=2,3,1&path=straight");
  await page.getByRole("button", { name: "Edit the maps of B" }).click();
  const list = page.locator(".side ol").first();
  const swatch = (map: number) =>
    list
      .locator("li")
      .nth(map - 1)
      .locator("span")
      .first()
      .evaluate((sign) => getComputedStyle(sign).getPropertyValue("--swatch"));
  const edge = (map: number) =>
    page
      .locator(".overlay")
      .getByRole("button", { name: new RegExp(`^Map ${map}(,.*move it|)$`) })
      .first()
      .evaluate((body) => getComputedStyle(body).color);
  const colours = [await swatch(1), await swatch(2), await swatch(3)];
  await page.getByRole("button", { name: "Done" }).click();
  await page.getByRole("button", { name: "Edit the maps of A" }).click();
  // What the first map of A becomes is the second of B, and so on.
  expect([await swatch(1), await swatch(2), await swatch(3)]).toEqual([colours[1], colours[2], colours[0]]);
  await page.getByRole("button", { name: "Edit the maps of B" }).click();
  const rgb = (hex: string) =>
    `rgb(${[1, 3, 5].map((at) => Number.parseInt(hex.slice(at, at + 2), 16)).join(", ")})`;
  expect([await edge(1), await edge(2), await edge(3)]).toEqual(colours.map(rgb));
});
