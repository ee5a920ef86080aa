import { expect, test } from "./fixture";

const TWO = "a=dragon-3&b=gasket&path=drawn:0.2,0.8;0.6,0.9&t=0.5";

test("a waypoint is moved by the mouse, by numbers and by keys", async ({ studio, page }) => {
  await studio.open(TWO);
  await test.step("dragged: one step of undo", async () => {
    const before = await studio.look();
    const from = await studio.place(0.2, 0.8);
    const to = await studio.place(0.5, 0.2);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 4 });
    await page.mouse.move(to.x, to.y, { steps: 4 });
    await page.mouse.up();
    const { path } = await studio.scene();
    expect(path.kind).toBe("drawn");
    expect(path.points[0]?.[0]).toBeCloseTo(0.5, 1);
    expect(path.points[0]?.[1]).toBeCloseTo(0.2, 1);
    expect(path.points[1]).toEqual([0.6, 0.9]);
    // The numbers beside follow.
    const [u, v] = path.points[0] ?? [];
    await expect(page.getByRole("spinbutton", { name: "turn and stretch, u" })).toHaveValue(String(u));
    await expect(page.getByRole("spinbutton", { name: "move, v" })).toHaveValue(String(v));
    expect((await studio.look()).hash).not.toBe(before.hash);

    await page.getByRole("button", { name: "Undo", exact: true }).click();
    expect((await studio.scene()).path.points).toEqual([
      [0.2, 0.8],
      [0.6, 0.9],
    ]);
    expect(await studio.look()).toEqual(before);
    await expect(page.getByRole("button", { name: "Undo", exact: true })).toBeDisabled();
    await page.getByRole("button", { name: "Redo", exact: true }).click();
    expect((await studio.scene()).path).toEqual(path);
    await page.getByRole("button", { name: "Undo", exact: true }).click();
  });
  await test.step("told in numbers, and bad ones change nothing", async () => {
    await studio.way(2).focus();
    const u = page.getByRole("spinbutton", { name: "turn and stretch, u" });
    await u.fill("3/4");
    await u.press("Enter");
    await expect(u).toHaveAttribute("data-settled", "true");
    expect((await studio.scene()).path.points[1]).toEqual([0.75, 0.9]);
    for (const bad of ["7", "three", "NaN", "1e999", ""]) {
      await u.fill(bad);
      await u.press("Enter");
      await expect(u).toHaveAttribute("aria-invalid", "true");
      await expect(u).toHaveAccessibleDescription(/Still 0\.75/);
    }
    expect((await studio.scene()).path.points[1]).toEqual([0.75, 0.9]);
    await u.press("Escape");
    await page.getByRole("button", { name: "Undo", exact: true }).click();
  });
  await test.step("moved, added and taken away by keys", async () => {
    await studio.way(1).focus();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Alt+ArrowUp");
    await page.keyboard.press("Shift+ArrowLeft");
    expect((await studio.scene()).path.points[0]).toEqual([0.209, 0.9]);
    await expect(studio.way(1)).toHaveAttribute("aria-valuetext", /^u 0\.21, v 0\.90, /);

    await page.keyboard.press("+");
    await expect(studio.way(2)).toBeFocused();
    expect((await studio.scene()).path.points).toHaveLength(3);
    await page.keyboard.press("Delete");
    await expect(studio.way(1)).toBeFocused();
    await page.keyboard.press("Delete");
    await expect(studio.way(1)).toHaveAccessibleName("Waypoint 1 of 1");
    await expect(studio.way(1)).toBeFocused();
    expect((await studio.scene()).path.points).toEqual([[0.6, 0.9]]);
    await page.keyboard.press("Delete");
    expect((await studio.scene()).path).toEqual({ kind: "drawn", points: [] });
    await expect(page.getByRole("slider", { name: "Position on the path" })).toBeFocused();
  });
});

test("the straight path is gone along, and bent, by the mouse", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight");
  await test.step("its own point is dragged along it", async () => {
    const from = await studio.place(0, 0);
    const to = await studio.place(0.6, 0.5);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 5 });
    await page.mouse.up();
    expect((await studio.scene()).t).toBeCloseTo(0.55, 1);
    expect((await studio.scene()).path.kind).toBe("straight");
  });
  await test.step("waypoints are added and taken away", async () => {
    // Twice on the path makes a waypoint there.
    const here = await studio.place(0.6, 0.61);
    await page.mouse.dblclick(here.x, here.y);
    const { path } = await studio.scene();
    expect(path.kind).toBe("drawn");
    expect(path.points).toHaveLength(1);
    expect(path.points[0]?.[0]).toBeCloseTo(0.6, 1);
    await expect(page.getByRole("radio", { name: "Drawn" })).toBeChecked();
    await page.getByRole("button", { name: "Remove this waypoint" }).click();
    expect((await studio.scene()).path.points).toEqual([]);

    // Where the picture is now; the picture stays.
    await studio.time.press("Home");
    for (let i = 0; i < 4; i++) await studio.time.press("PageUp");
    const before = await studio.look();
    await page.getByRole("button", { name: "Add waypoint" }).click();
    expect((await studio.scene()).path.points).toEqual([[0.4, 0.4]]);
    expect(await studio.look()).toEqual(before);
    const point = await studio.place(0.4, 0.4);
    await page.mouse.dblclick(point.x, point.y);
    expect((await studio.scene()).path.points).toEqual([]);
  });
});

test("the automatic path holds where the straight one breaks", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight");
  await studio.idle();
  const words = page.locator(".path-verdict");
  await expect(words).toHaveText(/^In pieces between \d+% and \d+%.*widest gap [\d.]+%/);
  await expect(page.getByRole("button", { name: /^Try to prove / })).toHaveCount(0);
  await page.getByRole("radio", { name: "Auto" }).check();
  await studio.idle();
  // It comes to the gasket where it holds exactly: nothing is known to be in pieces, however closely one looks.
  await expect(words).toHaveText(
    /^In one piece, proved, at \d+% of the sampled moments\. At the others no gap above 1\/600 was seen\./,
  );
  await expect(page.getByRole("button", { name: "Try to prove the whole path" })).toBeVisible();
  expect((await studio.scene()).path.points.length).toBeGreaterThan(0);
  const film = page.getByRole("list", { name: "Film of the morph" }).getByRole("button");
  await expect(film).toHaveCount(13);
  for (const frame of await film.all())
    await expect(frame).toHaveAccessibleName(/in one piece, proved|no gap seen/);
  await studio.time.focus();
  await studio.time.press("Home");
  for (let i = 0; i < 5; i++) await studio.time.press("PageUp");
  await studio.idle();
  await expect(studio.verdict).toHaveText(/In one piece, proved|No gap seen/);
  // Where a path is in pieces that no pixel shows, what is proved is said all the same, and no proof is offered that it
  // is whole.
  await studio.open("a=dragon-3&b=gasket&path=drawn:-0.125,1.15625;0.5,1.75;0.9375,1.59375;1,1.125");
  await studio.idle();
  await expect(words).toHaveText(
    /^In pieces between 9\d%.*, gap 0\.1\d%, under 1\/600 of its size, by Frond’s own bounds\.\s*$/,
  );
  await expect(page.getByRole("button", { name: "Try to bound the gaps of the path" })).toBeVisible();
});

test("a path has 64 waypoints at most", async ({ studio, page }) => {
  const points = Array.from({ length: 63 }, (_, i) => `${i / 63},${i % 2}`).join(";");
  await studio.open(`a=dragon-3&b=gasket&path=drawn:${points}`);
  const add = page.getByRole("button", { name: "Add waypoint" });
  await add.click();
  expect((await studio.scene()).path.points).toHaveLength(64);
  await page.keyboard.press("+");
  expect((await studio.scene()).path.points).toHaveLength(64);
  await page.getByRole("slider", { name: "Position on the path" }).focus();
  await expect(add).toBeDisabled();
  await expect(page).toHaveURL(/path=drawn/);
});

test("where the automatic path breaks, a way that holds is found and offered", async ({ studio, page }) => {
  await studio.open("a=koch&b=dragon&path=auto");
  const use = page.getByRole("button", { name: "Apply" });
  await use.waitFor({ timeout: 60_000 });
  await expect(page.locator(".side")).toContainText(
    "Pairing joint by joint keeps the morph in one piece, up to rounding.",
  );
  // Nothing was changed before it is asked for.
  const before = await studio.scene();
  expect(before.b.preset).toBe("dragon");
  await use.click();
  expect(await studio.scene()).toMatchObject({ mode: "linear", path: { kind: "straight" } });
  expect((await studio.scene()).a.maps).toHaveLength(4);
  await page.getByRole("button", { name: "Try to prove the whole path" }).click();
  await expect(page.getByText(/Proved for every moment of this path: .* one of 3 joints/)).toBeVisible({
    timeout: 30_000,
  });
  await page.getByRole("banner").getByRole("button", { name: "Undo" }).click();
  expect(await studio.scene()).toMatchObject({ mode: before.mode, a: before.a, b: before.b });
});
