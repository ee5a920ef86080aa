import { expect, test } from "./fixture";

test("keys do what their list says, and rest in a dialog and in a field", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight");
  await test.step("the list opens with ?, closes with Escape, and gives the focus back", async () => {
    await studio.time.focus();
    await page.keyboard.press("?");
    const list = page.getByRole("dialog", { name: "Help" });
    await expect(list).toBeVisible();
    await expect(list).toContainText("Play or pause");
    const licences = await list.getByRole("link", { name: /Licences/ }).getAttribute("href");
    const answer = await page.request.get(new URL(licences ?? "", page.url()).href);
    expect(await answer.text()).toContain("wgpu");
    // Keys of the page rest while a dialog is open.
    await page.keyboard.press("g");
    await page.keyboard.press("2");
    await page.keyboard.press("]");
    await expect(page.getByRole("dialog")).toHaveCount(1);
    await page.keyboard.press("Escape");
    await expect(page.getByRole("dialog")).toHaveCount(0);
    await expect(studio.time).toBeFocused();
    expect(await studio.scene()).toMatchObject({ t: 0, colouring: "map" });

    const opener = page.getByRole("banner").getByRole("button", { name: "Help" });
    await opener.click();
    await list.getByRole("button", { name: "Close" }).click();
    await expect(opener).toBeFocused();
  });
  await test.step("typing in a field moves nothing else", async () => {
    const before = await studio.scene();
    const field = page.getByRole("spinbutton", { name: "Time in percent" });
    await field.focus();
    await page.keyboard.type(" 2gze?");
    await expect(page.getByRole("dialog")).toHaveCount(0);
    await field.press("Escape");
    expect(await studio.scene()).toEqual(before);
    await field.blur();
  });
  await test.step("every key of the list does what it says", async () => {
    const body = page.locator("body");
    const t = async () => (await studio.scene()).t;
    await body.press("ArrowRight");
    expect(await t()).toBe(0.01);
    await body.press("Shift+ArrowLeft");
    expect(await t()).toBe(0.009);
    await expect(page.getByRole("list", { name: "Film of the morph" }).getByRole("button")).toHaveCount(13);
    await body.press("]");
    expect(await t()).toBeCloseTo(1 / 12, 3);
    await body.press("[");
    expect(await t()).toBe(0);
    await body.press("2");
    expect((await studio.scene()).colouring).toBe("address");
    await body.press("z");
    expect((await studio.scene()).colouring).toBe("map");
    await body.press("Shift+Z");
    expect((await studio.scene()).colouring).toBe("address");
    await body.press("Control+z");
    expect((await studio.scene()).colouring).toBe("map");
    await body.press("Control+y");
    expect((await studio.scene()).colouring).toBe("address");
    await body.press("g");
    await expect(page.getByRole("dialog", { name: "Shape A" })).toBeVisible();
    await page.keyboard.press("Escape");
    await body.press("e");
    await expect(page.getByRole("region", { name: "Maps of shape A" })).toBeVisible();
    await body.press("e");
    await expect(page.getByRole("region", { name: "Maps of shape A" })).toHaveCount(0);
    // The view glides back to the whole shape first.
    await studio.drawn();
    await page.getByRole("application", { name: /^The attractor/ }).press("+");
    await expect(page.getByTestId("zoom")).toHaveText("×1.3");
    await body.press("f");
    await expect(page.getByTestId("zoom")).toHaveText("×1.0");
  });
});

test("Tab walks the page in reading order, and never sticks", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket&path=drawn:0.2,0.8");
  await studio.idle();
  const stops: string[] = [];
  for (let presses = 0; presses < 80; presses++) {
    await page.keyboard.press("Tab");
    const stop = await page.evaluate(() => {
      const element = document.activeElement;
      if (!element || element === document.body) return "";
      const room = element.closest(".header, .stage, .side, .time");
      const box = element.getBoundingClientRect();
      const style = getComputedStyle(element);
      // A hidden native control stands in for what is drawn around it.
      const seen = box.width > 0 && box.height > 0 && style.visibility !== "hidden";
      return `${room?.className.split(" ")[0] ?? "?"}${seen ? "" : " unseen"}`;
    });
    if (stop === "") break;
    stops.push(stop);
  }
  expect(stops.filter((stop) => stop.includes("unseen") || stop === "?")).toEqual([]);
  const rooms = stops.filter((stop, i) => stop !== stops[i - 1]);
  // Play is right after the picture.
  expect(rooms).toEqual(["header", "stage", "time", "side"]);
  expect(stops.length).toBeGreaterThan(20);
});
