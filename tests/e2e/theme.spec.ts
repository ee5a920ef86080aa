import { palette } from "../../www/src/style/palette";
import { expect, test } from "./fixture";

test("light and dark: the page and the picture follow the system, and the choice", async ({
  studio,
  page,
}) => {
  await page.emulateMedia({ colorScheme: "light" });
  await studio.open("a=gasket&b=gasket");
  const ground = () =>
    page.locator("body").evaluate((body) => {
      const [r = 0, g = 0, b = 0] = (getComputedStyle(body).backgroundColor.match(/[\d.]+/g) ?? []).map(
        Number,
      );
      return r + g + b > 380 ? "light" : "dark";
    });
  const colours = async () => (await studio.look()).colours.slice(0, 3).sort();
  expect(await ground()).toBe("light");
  expect(await colours()).toEqual(palette("light").slice(0, 3).sort());
  await page.emulateMedia({ colorScheme: "dark" });
  await expect.poll(ground).toBe("dark");
  expect(await colours()).toEqual(palette("dark").slice(0, 3).sort());

  await page.getByRole("button", { name: "Theme: system; change" }).click();
  await expect.poll(ground).toBe("light");
  expect(await colours()).toEqual(palette("light").slice(0, 3).sort());
  await page.reload();
  await studio.time.waitFor();
  expect(await ground()).toBe("light");
  await page.getByRole("button", { name: "Theme: light; change" }).click();
  await page.emulateMedia({ colorScheme: "light" });
  await expect.poll(ground).toBe("dark");
});

test("a link brings its ground along where that is wanted, into the page, a frame and an element", async ({
  studio,
  page,
}) => {
  await page.emulateMedia({ colorScheme: "dark" });
  await studio.open("a=gasket&b=gasket");
  await page.getByRole("button", { name: "Share", exact: true }).click();
  const sheet = page.getByRole("dialog", { name: "Share" });
  const address = sheet.getByRole("textbox", { name: "Link" });
  await expect(address).not.toHaveValue(/theme=/);
  await sheet.getByRole("radio", { name: "Dark" }).check();
  await expect(address).toHaveValue(/[?&]theme=dark#/);
  // "As here" goes with the page, which is light below.
  const link = await address.inputValue();
  await page.evaluate(() => {
    const texts: string[] = [];
    Object.assign(globalThis, { texts });
    Object.defineProperty(navigator, "clipboard", {
      value: { writeText: async (text: string) => void texts.push(text) },
    });
  });
  await sheet.getByRole("button", { name: "Copy embed code" }).click();
  await sheet.getByRole("button", { name: "Copy element" }).click();
  const [frame = "", element = ""] = await page.evaluate(
    () => (globalThis as unknown as { texts: string[] }).texts,
  );
  expect(frame).toContain("theme=dark#");
  expect(frame).toContain('style="border:0;');
  expect(element).toContain(' theme="dark" style="max-width:640px;aspect-ratio:640/400"');

  await page.emulateMedia({ colorScheme: "light" });
  await page.goto(link);
  await studio.drawn();
  expect((await studio.look()).colours.slice(0, 3).sort()).toEqual(palette("dark").slice(0, 3).sort());
  await page.goto("about:blank");
  await studio.open("a=gasket&b=gasket");
  // It was for one visit.
  expect((await studio.look()).colours.slice(0, 3).sort()).toEqual(palette("light").slice(0, 3).sort());
});

test("nothing moves unless asked", async ({ studio }) => {
  await studio.open("a=gasket&b=gasket&t=0.5");
  await studio.idle();
  const before = [await studio.scene(), await studio.look()];
  expect([await studio.scene(), await studio.look()]).toEqual(before);
});

test("with reduced motion nothing eases, and play still plays", async ({ studio, page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await studio.open("a=gasket&b=gasket");
  await studio.drawn();
  const moving = await page.evaluate(
    () =>
      [...document.querySelectorAll("*")].filter((element) => {
        const { transitionDuration, animationName, animationDuration } = getComputedStyle(element);
        const lasts = (text: string) => text.split(",").some((part) => Number.parseFloat(part) > 0);
        return lasts(transitionDuration) || (animationName !== "none" && lasts(animationDuration));
      }).length,
  );
  expect(moving).toBe(0);
  expect((await studio.scene()).t).toBe(0);
  await page.getByRole("button", { name: "Play" }).click();
  await expect.poll(async () => (await studio.scene()).t).toBeGreaterThan(0);
});
