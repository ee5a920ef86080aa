import { expect, test } from "./fixture";

test("the gallery has its shapes, chosen with the mouse and with the keyboard", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket");
  await test.step("each has a picture of its own", async () => {
    await studio.idle();
    await page.getByRole("button", { name: /^Shape A: / }).click();
    const items = page.getByRole("dialog", { name: "Shape A" }).getByRole("listitem");
    await expect.poll(() => items.count()).toBeGreaterThanOrEqual(16);
    const pictures = await items.locator("canvas").evaluateAll((all) =>
      all.map((canvas) => {
        const { width, height } = canvas as HTMLCanvasElement;
        const image = (canvas as HTMLCanvasElement).getContext("2d")?.getImageData(0, 0, width, height);
        let lit = 0;
        let sum = 0;
        for (let i = 3; i < (image?.data.length ?? 0); i += 4) {
          if (!image?.data[i]) continue;
          lit++;
          sum = (sum * 31 + i) % 1_000_000_007;
        }
        return { share: lit / (width * height), sum };
      }),
    );
    for (const { share } of pictures) {
      expect(share).toBeGreaterThan(0.005);
      expect(share).toBeLessThan(0.95);
    }
    expect(new Set(pictures.map(({ sum }) => sum)).size).toBeGreaterThan(0.9 * pictures.length);
    await page.keyboard.press("Escape");
  });
  await test.step("with the mouse", async () => {
    const before = await studio.look();
    const card = page.getByRole("button", { name: /^Shape A: / });
    await card.click();
    await page
      .getByRole("dialog")
      .getByRole("button", { name: /^Twin-dragon/ })
      .click();
    await expect(page.getByRole("dialog")).toHaveCount(0);
    await expect(card).toHaveAccessibleName(/^Shape A: Twin-dragon, 2 copies/);
    await expect(card).toBeFocused();
    expect((await studio.scene()).a.preset).toBe("twindragon");
    expect((await studio.look()).hash).not.toBe(before.hash);
    await expect(page).toHaveURL(/a=twindragon/);
  });
  await test.step("with the keyboard", async () => {
    await studio.time.press("End");
    const before = await studio.look();
    const card = page.getByRole("button", { name: /^Shape B: / });
    await card.focus();
    await page.keyboard.press("Enter");
    await expect(page.getByRole("dialog", { name: "Shape B" })).toBeVisible();
    // The present shape has the focus; the next ones are an arrow away.
    await expect(page.getByRole("button", { name: /^Gasket/ })).toBeFocused();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Enter");
    await expect(card).toBeFocused();
    expect((await studio.scene()).b.preset).toBe("dragon-3");
    expect((await studio.look()).hash).not.toBe(before.hash);

    // Escape changes nothing, and gives the focus back.
    await page.keyboard.press("Enter");
    await expect(page.getByRole("dialog", { name: "Shape B" })).toBeVisible();
    await page.keyboard.press("End");
    await page.keyboard.press("Escape");
    await expect(page.getByRole("dialog")).toHaveCount(0);
    await expect(card).toBeFocused();
    expect((await studio.scene()).b.preset).toBe("dragon-3");
  });
});

test("the ends are swapped, and made the same", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&t=0.25");
  await page.getByRole("button", { name: "Swap A and B" }).click();
  expect(await studio.scene()).toMatchObject({ a: { preset: "gasket" }, b: { preset: "dragon-3" }, t: 0.75 });
  await page.getByRole("button", { name: "More for shape A" }).click();
  await page.getByRole("menuitem", { name: "Use as B too" }).click();
  expect(await studio.scene()).toMatchObject({ a: { preset: "gasket" }, b: { preset: "gasket" } });
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  expect(await studio.scene()).toMatchObject({ a: { preset: "dragon-3" }, b: { preset: "gasket" } });
});

test("swapped ends run the same morph backwards", async ({ studio, page }) => {
  // Map 2 turns by half a turn, which is equally short in either direction.
  await studio.open("a=dragon-3&b=gasket&t=0.5");
  await studio.idle();
  const [before, there] = [await studio.look(), (await studio.scene()).path.points];
  expect(there.length).toBeGreaterThan(0);
  await page.getByRole("button", { name: "Swap A and B" }).click();
  await studio.idle();
  const back = (await studio.scene()).path.points;
  expect(back).toHaveLength(there.length);
  for (const [i, [u, v]] of back.reverse().entries()) {
    expect(u + (there[i]?.[0] ?? Number.NaN)).toBeCloseTo(1, 9);
    expect(v + (there[i]?.[1] ?? Number.NaN)).toBeCloseTo(1, 9);
  }
  const after = await studio.look();
  expect(after.box).toEqual(before.box);
  expect(Math.abs(after.lit / before.lit - 1)).toBeLessThan(0.002);
  // The other half turn is that of eq 6: the link is one of those that had it counter-clockwise.
  await page.getByRole("button", { name: /^Turn map 2 / }).click();
  await studio.idle();
  expect((await studio.scene()).turns).toEqual([]);
});

test("shapes with different numbers of maps morph all the same", async ({ studio, page }) => {
  await studio.open("a=dragon&b=carpet&t=0.5");
  const look = await studio.look();
  expect(look.lit).toBeGreaterThan(1000);
  await expect(page.locator(".notes p").first()).toHaveText(/^(In shape|Shape) [AB]\b.*\bmaps\b.*\.$/);
  await expect(studio.verdict).toHaveText(/piece|gap seen|Not decided/);
});

test("a shape is found by its name, the focus comes back to its card, and the back button to the one before", async ({
  studio,
  page,
}) => {
  await studio.open("a=dragon&b=gasket");
  const begun = page.url();
  await page.locator("body").press("g");
  await page.getByRole("dialog", { name: "Shape A" }).waitFor();
  await page.keyboard.type("levy");
  await page.keyboard.press("Enter");
  const card = page.getByRole("button", { name: /^Shape A: Lévy curve/ });
  await expect(card).toBeFocused();
  expect((await studio.scene()).a.preset).toBe("levy");
  await page.goBack();
  await expect.poll(async () => (await studio.scene()).a.preset).toBe("dragon");
  expect(new URL(page.url()).pathname).toBe(new URL(begun).pathname);
  await page.goForward();
  await expect.poll(async () => (await studio.scene()).a.preset).toBe("levy");

  await page.locator("body").press("?");
  await expect(page.getByRole("dialog").getByRole("button", { name: "Close" })).not.toBeFocused();
  await page.keyboard.press("Escape");
  // What the picture looks like is said, in numbers that a drawing of the curve would show.
  await studio.idle();
  await page.locator("body").press("d");
  await expect(
    page.getByRole("status").filter({ hasText: "Lévy curve: 2 copies, each 0.707 times as large" }),
  ).toContainText("its own mirror image across a vertical line");
});
