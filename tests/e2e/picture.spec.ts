import { palette } from "../../www/src/style/palette";
import { expect, test } from "./fixture";

test(
  "the first picture is there, drawn by the backend of this project",
  { tag: "@webgpu" },
  async ({ studio, page }, info) => {
    await studio.open();
    const look = await studio.look();
    expect(await page.evaluate(() => window.frond?.backend())).toBe(info.project.name);
    const all = look.width * look.height;
    expect(look.lit).toBeGreaterThan(0.01 * all);
    expect(look.lit).toBeLessThan(0.9 * all);
    // Three maps, three colours, and none but those of the palette.
    expect(look.colours.slice(0, 3).sort()).toEqual(palette("light").slice(0, 3).sort());
    expect(await studio.said()).toEqual([]);
    // What stood in for it until then is gone.
    await expect(page.locator(".picture canvas")).toHaveCount(1);
  },
);

test.describe("the first picture", () => {
  test.use({ alone: true });

  test("does not wait for the workers", async ({ studio, page }) => {
    await page.addInitScript(() => {
      // On a slow machine the workers would not wait for ever; here they have to.
      const wait = window.setTimeout;
      window.setTimeout = ((then: () => void, ms?: number) =>
        wait(then, ms !== undefined && ms >= 1000 ? 1e9 : ms)) as typeof setTimeout;
      const lit = (canvas: HTMLCanvasElement) => {
        const { width, height } = canvas;
        // Only what was computed without the renderer can be read here: a canvas of its has another context.
        return (
          canvas
            .getContext("2d")
            ?.getImageData(0, 0, width, height)
            .data.some((x) => x > 0) === true
        );
      };
      const Real = window.Worker;
      window.Worker = class extends Real {
        constructor(...given: ConstructorParameters<typeof Worker>) {
          const pictures = [...document.querySelectorAll<HTMLCanvasElement>(".picture canvas")];
          const seen = pictures.some(lit) || document.querySelector(".readout-points") !== null;
          document.documentElement.dataset["before"] ??= seen ? "a picture" : "nothing";
          super(...given);
        }
      };
    });
    await studio.open();
    await studio.idle();
    await expect(page.locator("html")).toHaveAttribute("data-before", "a picture");
  });
});

test("it agrees with the adaptive cut", { tag: "@webgpu" }, async ({ studio }) => {
  // Points, lines, areas, very uneven pieces, and the middle of a morph; each in place of the one before.
  for (const link of [
    "a=dust&b=dust",
    "a=koch&b=koch",
    "a=dragon-3&b=gasket&path=straight&t=0.5",
    "a=fern&b=fern",
  ]) {
    await test.step(link, async () => {
      await studio.open(link);
      expect(await studio.likeness()).toBeGreaterThanOrEqual(0.995);
    });
  }
});

test("the gasket is where mathematics puts it", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket");
  const { box, lit } = await studio.look();
  const [left, top, right, bottom] = box;
  const side = right - left;
  expect(side / (bottom - top)).toBeCloseTo(2 / Math.sqrt(3), 2);
  // 3^n of 4^n small triangles: with pixels of size h the area is about side^1.585 h^0.415.
  expect(lit / side ** (Math.log(3) / Math.log(2))).toBeGreaterThan(0.4);
  expect(lit / side ** (Math.log(3) / Math.log(2))).toBeLessThan(2.5);
  const at = await page.evaluate(
    async (points) => {
      const picture = await window.frond?.readPixels();
      return points.map(([x = 0, y = 0]) => {
        let alpha = 0;
        for (let dy = -3; dy <= 3; dy++) {
          for (let dx = -3; dx <= 3; dx++) {
            const i = 4 * (Math.round(y + dy) * (picture?.width ?? 0) + Math.round(x + dx)) + 3;
            alpha = Math.max(alpha, picture?.data[i] ?? 0);
          }
        }
        return alpha > 0;
      });
    },
    [
      [left, bottom],
      [right, bottom],
      [(left + right) / 2, top],
      [(left + right) / 2, bottom],
      // The middles of the largest hole and of two of the next.
      [(left + right) / 2, top + (2 / 3) * (bottom - top)],
      [left + side / 4, bottom - (bottom - top) / 6],
      [(left + right) / 2, top + (bottom - top) / 3],
    ],
  );
  expect(at).toEqual([true, true, true, true, false, false, false]);
});

test("the wheel zooms, dragging pans, and the fit brings the first picture back", { tag: "@webgpu" }, async ({
  studio,
  page,
}) => {
  await studio.open("a=gasket&b=gasket");
  const first = await studio.look();
  const stage = page.getByRole("application", { name: /^The attractor/ });
  const box = await stage.boundingBox();
  if (!box) throw new Error("no stage");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.wheel(0, -500);
  await expect(page.getByTestId("zoom")).toHaveText("×2.2");
  const near = await studio.look();
  expect(near.hash).not.toBe(first.hash);
  expect(await studio.likeness()).toBeGreaterThanOrEqual(0.995);

  await page.mouse.down();
  await page.mouse.move(x + 120, y + 60, { steps: 3 });
  await page.mouse.up();
  const moved = await studio.look();
  expect(moved.hash).not.toBe(near.hash);
  await expect(page).toHaveURL(/view=/);

  await page.getByRole("button", { name: "Fit to the stage" }).click();
  expect(await studio.look()).toEqual(first);
  await expect(page).not.toHaveURL(/view=/);
});

test("deep zooms stay sharp", { tag: "@webgpu" }, async ({ studio, page }) => {
  // Beyond what 32 bits could tell apart: the fixed point of the first map looks the same at every power of two.
  await studio.open("a=gasket&b=gasket&view=0,0,1048576");
  const deep = await studio.look();
  expect(deep.lit).toBeGreaterThan(1000);
  expect(await studio.likeness()).toBeGreaterThanOrEqual(0.995);
  await studio.open("a=gasket&b=gasket&view=0,0,1024");
  const less = await studio.look();
  expect(Math.abs(less.lit - deep.lit)).toBeLessThan(0.01 * less.lit);
  await expect(page.getByTestId("zoom")).toHaveText("×1024");
});

test("the three colourings are three pictures of one shape", { tag: "@webgpu" }, async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket");
  const map = await studio.look();
  await page.getByRole("radio", { name: "Address" }).check();
  const address = await studio.look();
  await page.locator("body").press("3");
  await expect(page.getByRole("radio", { name: "Density" })).toBeChecked();
  const density = await studio.look();
  expect(new Set([map.hash, address.hash, density.hash]).size).toBe(3);
  for (const other of [address, density]) {
    expect(Math.abs(other.lit - map.lit)).toBeLessThan(0.02 * map.lit);
  }
  expect(address.colours.length).toBeGreaterThan(map.colours.length);
  await page.locator("body").press("1");
  expect(await studio.look()).toEqual(map);
});

test("turning and linear stand side by side", { tag: "@webgpu" }, async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&path=straight&t=0.5");
  const alone = await studio.look();
  await page.getByRole("switch", { name: /side by side/ }).check();
  await expect(page.locator(".pane canvas")).toHaveCount(2);
  await expect(page.getByText("By rotation (polar)")).toBeVisible();
  await expect(page.getByText("Entry by entry (linear)")).toBeVisible();
  const half = await studio.look();
  expect(half.width).toBeLessThan(0.6 * alone.width);
  expect(half.lit).toBeGreaterThan(1000);
  // Half-way the pieces of the linear one are much smaller: it is all but dust.
  const linear = await studio.look("linear");
  expect(linear.lit).toBeGreaterThan(100);
  expect(linear.lit).toBeLessThan(half.lit);
  expect(await studio.likeness("main")).toBeGreaterThanOrEqual(0.995);
  expect(await studio.likeness("linear")).toBeGreaterThanOrEqual(0.995);
  // At the ends there is no difference but a pixel of width.
  await studio.time.press("End");
  const ends = [await studio.look("main"), await studio.look("linear")].map(({ lit }) => lit);
  expect(Math.max(...ends)).toBeLessThan(1.02 * Math.min(...ends));
  await expect(page).toHaveURL(/compare=1/);
});
