import { readFile } from "node:fs/promises";
import { expectClean } from "./axe";
import { apart, FitTool, file, inLeaf, PAPER } from "./fit-tool";
import { expect, test } from "./fixture";
import { png, type Rgb } from "./png";

test.use({ alone: true });

const RED: Rgb = [190, 40, 40];
const BLUE: Rgb = [40, 70, 190];

/** A leaf of one colour, its upper half a darker one, taller or wider. */
const leaf = (colour: Rgb, across: number, up: number) =>
  png(300, 300, (x, y) => {
    if (!inLeaf(150 + (x - 150) / across, 150 + (y - 150) / up, 150, 150, 125)) return PAPER;
    return y < 150 ? (colour.map((part) => Math.round(part / 2)) as Rgb) : colour;
  });

test("two leaves become each other with their photographs, which a reload finds on the shelf", async ({
  page,
}) => {
  const tool = new FitTool(page);
  await tool.openFew(40);
  for (const [name, picture, end] of [
    ["red", leaf(RED, 1, 0.8), "A"],
    ["blue", leaf(BLUE, 0.7, 1), "B"],
  ] as const) {
    await tool.input.setInputFiles(file(picture, `${name}.png`));
    await page.getByRole("button", { name: "Fit this outline" }).click();
    await tool.fitted();
    await page.getByRole("button", { name: "Save this fit" }).click();
    await expect(page.getByRole("button", { name: "Saved" })).toBeVisible();
    await page.getByRole("button", { name: `Use as ${end}` }).click();
    await expect(page.getByRole("slider", { name: "Time", exact: true })).toBeVisible();
    if (end === "A") await page.getByRole("link", { name: "Fit", exact: true }).click();
  }

  const shown = page.getByRole("switch", { name: "Their photos" });
  /** The colours below and above the middle of the picture, once it is drawn. */
  const middle = async (): Promise<[Rgb, Rgb]> => {
    await page.evaluate(() => window.frond?.drawn());
    return page.evaluate(async () => {
      const { width, height, data } = (await window.frond?.readPixels("main")) ?? {
        width: 0,
        height: 0,
        data: [],
      };
      const at = (down: number): [number, number, number] => {
        const i = 4 * (Math.round(down * height) * width + (width >> 1));
        return [data[i] ?? 0, data[i + 1] ?? 0, data[i + 2] ?? 0];
      };
      return [at(0.66), at(0.36)];
    });
  };
  const near = (colour: Rgb, wanted: Rgb) => expect(apart(colour, wanted)).toBeLessThan(24);
  const dark = (colour: Rgb) => colour.map((part) => part / 2) as Rgb;
  const time = page.getByRole("slider", { name: "Time", exact: true });

  for (const again of [false, true]) {
    if (again) await page.reload();
    await expect(shown).toBeChecked();
    await time.focus();
    await page.keyboard.press("Home");
    let [below, above] = await middle();
    near(below, RED);
    near(above, dark(RED));
    await page.keyboard.press("End");
    [below, above] = await middle();
    near(below, BLUE);
    near(above, dark(BLUE));
  }
  await page.getByRole("spinbutton", { name: "Time in percent" }).fill("50");
  await page.keyboard.press("Enter");
  const half = RED.map((part, i) => (part + (BLUE[i] ?? 0)) / 2) as Rgb;
  const [below, above] = await middle();
  near(below, half);
  near(above, dark(half));
  await expectClean(page);
  // The strip below shows them, too.
  await expect
    .poll(() =>
      page.evaluate(() => {
        const [first] = document.querySelectorAll<HTMLCanvasElement>(".strip canvas");
        if (!first) return [0, 0, 0];
        const { width, height } = first;
        const pixel = first.getContext("2d")?.getImageData(width >> 1, Math.round(0.66 * height), 1, 1).data;
        return [...(pixel ?? [])].slice(0, 3);
      }),
    )
    .toEqual(RED.map((part) => expect.closeTo(part, -1.5)));
  // So does a film, unless it is to show the curves alone.
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByRole("menuitem", { name: "Film …" }).click();
  const dialog = page.getByRole("dialog", { name: "Export" });
  const leaves = dialog.getByRole("switch", { name: "With the photos" });
  await expect(leaves).toBeChecked();
  await dialog.getByRole("radio", { name: "APNG" }).check({ force: true });
  for (const [name, value] of Object.entries({ Width: "96", Height: "96", Length: "0.5" })) {
    await dialog.getByRole("spinbutton", { name }).fill(value);
    await dialog.getByRole("spinbutton", { name }).press("Enter");
  }
  for (const on of [true, false]) {
    await leaves.setChecked(on, { force: true });
    const download = page.waitForEvent("download");
    await dialog.getByRole("button", { name: "Render the film" }).click();
    const bytes = await readFile(await (await download).path());
    const first = await page.evaluate(async (base64) => {
      const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([data], { type: "image/png" }));
      const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
      context?.drawImage(image, 0, 0);
      const pixel = context?.getImageData(image.width >> 1, Math.round(0.66 * image.height), 1, 1).data;
      return [...(pixel ?? [])].slice(0, 3) as [number, number, number];
    }, bytes.toString("base64"));
    if (on) near(first, RED);
    else expect(apart(first, RED)).toBeGreaterThan(24);
    await dialog.getByRole("button", { name: "Make another" }).click();
  }
  await page.keyboard.press("Escape");
  await shown.uncheck({ force: true });
  expect(apart((await middle())[0], half)).toBeGreaterThan(24);
});
