import type { Page } from "@playwright/test";
import { expect, test } from "./fixture";
import { png } from "./png";
import type { Studio } from "./studio";

// A picture costs by its pixels.
test.use({ viewport: { width: 960, height: 640 } });

const GASKET = "v=1&a=gasket&b=gasket&path=straight&tool=deform";

/** Red, green, blue and white quarters, twice as wide as high. */
const quarters = png(240, 120, (x, y) =>
  x < 120 ? (y < 60 ? [255, 0, 0] : [0, 0, 255]) : y < 60 ? [0, 160, 0] : [255, 255, 255],
);

const picture = (buffer: Buffer, name: string, mimeType = "image/png") => ({ buffer, name, mimeType });
/** In its card: what is spoken names it, too. */
const name = (page: Page, text: string) =>
  page.getByRole("region", { name: "Your picture" }).locator(".subject-name", { hasText: text });
const file = (page: Page) => page.getByLabel("Picture file");

/** Opens the tool with the sample on the stage. */
async function withSample(studio: Studio, page: Page, query = ""): Promise<void> {
  await studio.open(GASKET, query);
  await page.getByRole("radio", { name: "Picture" }).check({ force: true });
  await expect(name(page, "Sample: ferns at dusk")).toBeVisible();
}

/** Pixels that are not all covered, in the middle part of the picture. */
async function holes(studio: Studio, page: Page): Promise<number> {
  const { box } = await studio.look();
  return page.evaluate(async ([left, top, right, bottom]) => {
    const { width, data } = (await window.frond?.readPixels()) ?? { width: 0, data: [] };
    let open = 0;
    const inner = (low: number, high: number) =>
      [low + 0.3 * (high - low), high - 0.3 * (high - low)] as const;
    const [[x0, x1], [y0, y1]] = [inner(left, right), inner(top, bottom)];
    for (let y = Math.ceil(y0); y < y1; y++) {
      for (let x = Math.ceil(x0); x < x1; x++) if (data[4 * (y * width + x) + 3] !== 255) open++;
    }
    return open;
  }, box);
}

async function pull(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Show me" }).click();
}

test("the sample is there at once, whole, and bends without a crack at any locality", {
  tag: "@webgpu",
}, async ({ studio, page }) => {
  await withSample(studio, page);
  const still = await studio.look();
  const [left, top, right, bottom] = still.box;
  expect((right - left) / (bottom - top)).toBeCloseTo(4 / 3, 1);
  expect(still.lit).toBeGreaterThan(0.98 * (right - left) * (bottom - top));
  expect(still.colours.length).toBeGreaterThan(1000);
  expect(await studio.likeness()).toBeGreaterThan(0.99);

  await pull(page);
  const bent = await studio.look();
  expect(bent.hash).not.toBe(still.hash);
  expect(await studio.likeness()).toBeGreaterThan(0.98);
  expect(await holes(studio, page)).toBe(0);
  const locality = page.getByRole("slider", { name: "Locality", exact: true });
  await locality.focus();
  for (const key of ["PageUp", "PageUp", "PageUp", "End"]) {
    await page.keyboard.press(key);
    expect(await holes(studio, page)).toBe(0);
  }
});

test("a picture of one's own is chosen, bent, and gives way to the sample", { tag: "@webgpu" }, async ({
  studio,
  page,
}) => {
  await withSample(studio, page);
  await file(page).setInputFiles(picture(quarters, "flag.png"));
  await expect(page.getByText("240 × 120 pixels")).toBeVisible();
  const look = await studio.look();
  const [left, top, right, bottom] = look.box;
  expect((right - left) / (bottom - top)).toBeCloseTo(2, 1);
  expect(look.colours.slice(0, 4).sort()).toEqual(["#0000ff", "#00a000", "#ff0000", "#ffffff"]);
  const { box } = (await studio.scene()).deform ?? { box: [0, 0, 0, 0] };
  expect((box[2] - box[0]) / (box[3] - box[1])).toBeCloseTo(2, 6);
  await pull(page);
  expect((await studio.look()).hash).not.toBe(look.hash);
  expect(await studio.likeness()).toBeGreaterThan(0.98);
  await page.getByRole("button", { name: "Back to the sample" }).click();
  await expect(name(page, "Sample: ferns at dusk")).toBeVisible();
  expect((await studio.look()).colours.length).toBeGreaterThan(500);
});

test("what cannot be bent is refused with the reason, and the last picture stays", async ({
  studio,
  page,
}) => {
  await withSample(studio, page);
  await file(page).setInputFiles(picture(quarters, "flag.png"));
  await expect(page.getByText("240 × 120 pixels")).toBeVisible();
  const before = (await studio.look()).hash;
  const huge = Buffer.from(png(1, 1, () => [0, 0, 0]));
  huge.writeUInt32BE(10_000, 16);
  huge.writeUInt32BE(10_000, 20);
  for (const [given, words] of [
    [picture(Buffer.from('<svg xmlns="x"/>'), "leaf.svg", "image/svg+xml"), /leaf\.svg.*Save it as PNG/],
    [picture(Buffer.from('<?xml version="1.0"?><svg/>'), "hidden.png"), /hidden\.png.*Save it as PNG/],
    [picture(huge, "huge.png"), /10,000 × 10,000 .*100 megapixels\. The limit is 64/],
    [picture(Buffer.from("milk, bread"), "notes.png"), /notes\.png.* PNG, JPEG, WebP/],
    [picture(quarters.subarray(0, 60), "half.png"), /half\.png.* damaged or incomplete/],
    [picture(Buffer.alloc(0), "nothing.png"), /nothing\.png/],
  ] as const) {
    await file(page).setInputFiles(given);
    await expect(studio.alerts.filter({ hasText: words })).toBeVisible();
    await studio.alerts.first().getByRole("button", { name: "Dismiss" }).click();
  }
  await expect(name(page, "flag.png")).toBeVisible();
  expect((await studio.look()).hash).toBe(before);
});

test("pictures are dropped on the stage and pasted", async ({ studio, page }) => {
  await withSample(studio, page);
  const bytes = [...quarters];
  const arrive = (how: "drop" | "paste", called: string) =>
    page.evaluate(
      ({ how, called, bytes }) => {
        const data = new DataTransfer();
        data.items.add(new File([new Uint8Array(bytes)], called, { type: "image/png" }));
        const stage = document.querySelector(".stage") ?? document.body;
        const event =
          how === "drop"
            ? new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true })
            : new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true });
        return !stage.dispatchEvent(event);
      },
      { how, called, bytes },
    );
  expect(await arrive("drop", "dropped.png")).toBe(true);
  await expect(name(page, "dropped.png")).toBeVisible();
  expect(await arrive("paste", "pasted.png")).toBe(true);
  await expect(name(page, "pasted.png")).toBeVisible();
  expect((await studio.look()).colours[0]).toMatch(/^#(ff0000|00a000|0000ff|ffffff)$/);
});

test("a link brings the bend and says where the picture is; a shape comes back whole", {
  tag: "@webgpu",
}, async ({ studio, page }) => {
  await withSample(studio, page);
  await pull(page);
  const bent = (await studio.look()).hash;
  await expect.poll(() => page.url()).toContain("picture");
  await studio.open(new URL(page.url()).hash.slice(1));
  await expect.poll(() => studio.said()).toContain("The link does not contain the picture. Choose it again.");
  await expect(name(page, "Sample: ferns at dusk")).toBeVisible();
  expect((await studio.look()).hash).toBe(bent);
  await page.getByRole("radio", { name: "Shape" }).check({ force: true });
  const shape = await studio.look();
  expect(shape.hash).not.toBe(bent);
  expect(await studio.likeness()).toBeGreaterThan(0.97);
});

test("it is the same without a graphics card", async ({ studio, page }) => {
  await withSample(studio, page, "?backend=canvas");
  await pull(page);
  expect(await studio.likeness()).toBe(1);
  await expect.poll(() => holes(studio, page)).toBe(0);
  await file(page).setInputFiles(picture(quarters, "flag.png"));
  await expect(page.getByText("240 × 120 pixels")).toBeVisible();
  expect((await studio.look()).colours.length).toBeGreaterThan(3);
});
