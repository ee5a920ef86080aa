import { expect, test } from "./fixture";

test("maps are changed by hand, by numbers and by keys, and their number, too", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket&path=straight");
  await test.step("a parallelogram is dragged by its corner: one step of undo", async () => {
    await page.getByRole("button", { name: "Edit the maps of A" }).click();
    // The map of the morph, which follows, is in sight beside the numbers.
    await expect(studio.square).toBeInViewport({ ratio: 1 });
    const before = await studio.look();
    const { maps } = (await studio.scene()).a;
    const grip = page.getByRole("button", { name: /^Map 1, turns and scales it/ });
    const box = await grip.boundingBox();
    if (!box) throw new Error("no grip");
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 30, y + 10, { steps: 3 });
    await page.mouse.move(x - 60, y + 10, { steps: 3 });
    await page.mouse.up();
    const { a } = await studio.scene();
    expect(a.preset).toBeUndefined();
    expect(a.maps[0]).not.toEqual(maps[0]);
    // Its lower left corner, and the other maps, stay where they are.
    expect(a.maps[0]?.slice(4)).toEqual([expect.closeTo(0), expect.closeTo(0)]);
    expect(a.maps.slice(1)).toEqual(maps.slice(1));
    expect((await studio.look()).hash).not.toBe(before.hash);
    await expect(page.getByRole("button", { name: /^Shape A: Gasket, 3 copies, edited/ })).toBeVisible();

    await page.getByRole("button", { name: "Undo", exact: true }).click();
    expect((await studio.scene()).a).toMatchObject({ preset: "gasket", maps });
    await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
  });
  await test.step("numbers are typed, bad ones are explained, and the last good shape stays", async () => {
    await page.getByRole("radio", { name: "Six numbers" }).check();
    const a = page.getByRole("spinbutton", { name: "New x from x, a" });
    await a.fill("√3/4");
    await a.press("Enter");
    await expect(a).toHaveAttribute("data-settled", "true");
    const good = (await studio.scene()).a;
    expect(good.maps[0]?.[0]).toBeCloseTo(Math.sqrt(3) / 4, 12);
    const look = await studio.look();
    for (const bad of ["", "abc", "1e999", "NaN", "1/0", "5"]) {
      await a.fill(bad);
      await a.press("Enter");
      await expect(a).toHaveAttribute("aria-invalid", "true");
      await expect(page.getByRole("alert").filter({ hasText: "Still 0.43301." })).toBeVisible();
      expect((await studio.scene()).a).toEqual(good);
    }
    await a.press("Escape");
    await expect(a).toHaveValue("√3/4");
    await expect(a).toHaveAttribute("aria-invalid", "false");
    expect(await studio.look()).toEqual(look);
    await page.getByRole("button", { name: "Done" }).click();
    await expect(page.getByRole("button", { name: "Edit the maps of A" })).toBeFocused();
    await expect(page.getByRole("heading", { name: "Path" })).toBeVisible();
    await page.getByRole("button", { name: "Undo", exact: true }).click();
  });
  await test.step("parallelograms are reached, chosen and moved by keys", async () => {
    await page.locator("body").press("e");
    const { maps } = (await studio.scene()).a;
    await studio.drawn();
    await page.getByRole("application", { name: /^The attractor/ }).focus();
    const second = page.getByRole("button", { name: /^Map 2(, chosen.*)?$/ });
    const focused = () => second.evaluate((element) => element === document.activeElement);
    await expect(second).toHaveJSProperty("tabIndex", 0);
    for (let presses = 0; presses < 20 && !(await focused()); presses++) await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    await expect(second).toHaveAttribute("aria-pressed", "true");
    await expect(second).toBeFocused();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Shift+ArrowUp");
    const moved = (await studio.scene()).a.maps[1] ?? [];
    expect(moved.slice(0, 4)).toEqual(maps[1]?.slice(0, 4));
    expect(moved[4]).toBeGreaterThan(maps[1]?.[4] ?? 0);
    expect(moved[5]).toBeGreaterThan(maps[1]?.[5] ?? 0);
  });
  await test.step("the whole shape is taken in hand: its parameters move, its points are told to be the same", async () => {
    const before = (await studio.scene()).a.maps;
    const undo = page.getByRole("button", { name: "Undo", exact: true });
    await page.locator("body").press("Shift+E");
    const table = page.getByRole("region", { name: "Parameters", exact: true });
    await expect(table).toContainText("All as before");
    await page.getByRole("button", { name: /^The full shape, only turns it/ }).press("ArrowLeft");
    await page.getByRole("spinbutton", { name: "Angle" }).fill("85");
    await page.getByRole("spinbutton", { name: "Angle" }).press("Enter");
    await expect(table).toContainText(
      /numbers are not as before.*2,000 points: apart by less than .*, which is rounding/,
    );
    expect((await studio.scene()).a.maps).not.toEqual(before);
    await undo.click();
    await undo.click();
    expect((await studio.scene()).a.maps).toEqual(before);
    await expect(table).toContainText("All as before");
    await page.getByRole("radio", { name: "Map by map" }).check();
  });
  await test.step("maps are added, copied, mirrored, taken away, and reset", async () => {
    await page.getByRole("button", { name: "Reset" }).click();
    const before = await studio.look();
    const count = async () => (await studio.scene()).a.maps.length;
    await page.getByRole("button", { name: "Add a map" }).click();
    expect(await count()).toBe(4);
    expect((await studio.look()).lit).toBeGreaterThan(before.lit);
    await page.getByRole("button", { name: "Duplicate this map" }).click();
    expect(await count()).toBe(5);
    await page.getByRole("button", { name: "Mirror this map" }).click();
    const mirrored = (await studio.scene()).a.maps[4] ?? [0, 0, 0, 0, 0, 0];
    expect(mirrored[0] * mirrored[3] - mirrored[1] * mirrored[2]).toBeLessThan(0);
    for (let left = 4; left >= 1; left--) {
      await page.getByRole("button", { name: "Remove this map" }).click();
      expect(await count()).toBe(left);
    }
    await expect(page.getByRole("button", { name: "Remove this map" })).toBeDisabled();
    // One map is one point: there is a picture of it, and it is in one piece.
    await expect(studio.verdict).toHaveText(/In one piece/);
    await page.getByRole("button", { name: "Reset" }).click();
    expect((await studio.scene()).a.preset).toBe("gasket");
    expect(await studio.look()).toEqual(before);
  });
});

test("a number moves its own map, whatever lies over it", async ({ studio, page }) => {
  await studio.open("a=tree&b=gasket&path=straight");
  await page.locator("body").press("e");
  const { maps } = (await studio.scene()).a;
  for (const number of [1, 2, 3, 4]) {
    const box = await page.locator(".overlay").getByText(`${number}`, { exact: true }).boundingBox();
    if (!box) throw new Error(`there is no number ${number}`);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 5, y - 9, { steps: 3 });
    await page.mouse.move(x + 12, y - 20, { steps: 3 });
    await page.mouse.up();
    const now = (await studio.scene()).a.maps;
    expect(now.flatMap((map, i) => (`${map}` === `${maps[i]}` ? [] : [i + 1]))).toEqual([number]);
    await page.getByRole("button", { name: "Undo", exact: true }).click();
  }
});

test("a shape has 64 maps at most", async ({ studio, page }) => {
  const maps = Array.from({ length: 63 }, (_, i) => `0.1,0,0,0.1,${i % 8},${i >> 3}`).join(";");
  await studio.open(`a=maps:${maps}&b=gasket`);
  await page.getByRole("button", { name: "Edit the maps of A" }).click();
  const add = page.getByRole("button", { name: "Add a map" });
  await add.click();
  expect((await studio.scene()).a.maps).toHaveLength(64);
  await expect(add).toBeDisabled();
  await expect(page.getByRole("button", { name: "Duplicate this map" })).toBeDisabled();
});
