import type { Locator, Page } from "@playwright/test";
import type { Scene } from "../../crate/web/src/api";
import { expect } from "./fixture";
import { png, type Rgb } from "./png";

export const PAPER: Rgb = [244, 243, 238];
export const GREEN: Rgb = [62, 120, 44];
const RULE: Rgb = [200, 212, 226];

/** How far the margin of a toothed leaf is from its middle, in a direction. */
function reach(angle: number): number {
  return (
    0.62 + 0.2 * Math.cos(5 * angle) + 0.05 * Math.abs(Math.sin(17 * angle)) + 0.02 * Math.cos(43 * angle)
  );
}

/** Whether a leaf of a size with its middle at (x0, y0) covers a pixel. */
export function inLeaf(x: number, y: number, x0: number, y0: number, size: number): boolean {
  const [dx, dy] = [(x - x0) / size, (y0 - y) / size];
  return Math.hypot(dx, dy) < reach(Math.atan2(dx, dy));
}

/** A green leaf on ruled paper, made for the tests. */
export const leafPicture = png(360, 400, (x, y) => {
  if (inLeaf(x, y, 180, 190, 170)) return GREEN;
  return y % 24 === 0 ? RULE : PAPER;
});

/** The same with a stalk. */
export const stalkedPicture = png(360, 460, (x, y) =>
  inLeaf(x, y, 180, 150, 140) || (Math.abs(x - 180) < 3 && y > 150 && y < 440) ? GREEN : PAPER,
);

export const twoLeaves = png(420, 240, (x, y) =>
  inLeaf(x, y, 115, 120, 105) || inLeaf(x, y, 315, 120, 80) ? GREEN : PAPER,
);

export const blank = png(200, 150, () => PAPER);

export const noise = png(240, 180, (x, y) => {
  let h = Math.imul(x + 1, 0x9e3779b1) ^ Math.imul(y + 7, 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
  const v = ((h ^ (h >>> 13)) >>> 0) % 256;
  return [v, v, v];
});

export const file = (buffer: Buffer | string, name: string, mimeType = "image/png") => ({
  buffer: typeof buffer === "string" ? Buffer.from(buffer) : buffer,
  name,
  mimeType,
});

/** The fit, as a person meets it. */
export class FitTool {
  readonly page: Page;
  readonly status: Locator;
  readonly stage: Locator;
  readonly input: Locator;
  readonly figures: Locator;
  readonly alerts: Locator;
  readonly messages: Locator;
  readonly problem: Locator;

  constructor(page: Page) {
    this.page = page;
    this.status = page.getByTestId("fit-status");
    this.stage = page.getByTestId("fit-stage");
    this.input = page.getByLabel("Photo or outline file");
    this.figures = page.getByTestId("figures");
    this.alerts = page.locator(".toasts").getByRole("alert");
    this.messages = page.getByRole("region", { name: "Cut out" }).getByRole("status");
    this.problem = page.getByRole("region", { name: "Accuracy" }).getByRole("alert");
  }

  /** With few numbers from the start: they are fitted soon. */
  async openFew(numbers: number): Promise<void> {
    await this.open(`v=1&a=gasket&b=gasket&path=straight&tool=fit&fit=outline:closed,${numbers},0`);
  }

  async open(fragment = "v=1&a=gasket&b=gasket&path=straight&tool=fit"): Promise<void> {
    if (this.page.url() !== "about:blank") await this.page.goto("about:blank");
    await this.page.goto(`./#${fragment}`);
    await this.status.waitFor();
  }

  /** There is a fit, and nothing better is being looked for. */
  async fitted(): Promise<void> {
    await expect(this.status).toHaveText(/^\d.* error, \d+ numbers$/);
  }

  async few(numbers: number): Promise<void> {
    const field = this.page.getByRole("spinbutton", { name: "Numbers in the fit" });
    await field.fill(String(numbers));
    await field.press("Enter");
  }

  async scene(): Promise<Scene> {
    const scene = await this.page.evaluate(() => window.frond?.scene());
    if (!scene) throw new Error("the page has no hook");
    return scene;
  }

  /** The colour of the stage at a place, in parts of its width and height; null where nothing is drawn. */
  async colourAt(x: number, y: number): Promise<Rgb | null> {
    return this.stage.locator("canvas").evaluate(
      (canvas: HTMLCanvasElement, [x, y]) => {
        const data = canvas
          .getContext("2d")
          ?.getImageData(Math.round(x * canvas.width), Math.round(y * canvas.height), 1, 1).data;
        return data?.[3] ? ([data[0] ?? 0, data[1] ?? 0, data[2] ?? 0] as [number, number, number]) : null;
      },
      [x, y] as const,
    );
  }

  /** How many pixels of the stage hold something. */
  async lit(): Promise<number> {
    return this.stage.locator("canvas").evaluate((canvas: HTMLCanvasElement) => {
      const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
      let lit = 0;
      for (let i = 3; i < data.length; i += 4) if (data[i]) lit++;
      return lit;
    });
  }

  /** Where a pixel of a picture is on the page, while all of the picture is shown. */
  async place(x: number, y: number, width: number, height: number): Promise<{ x: number; y: number }> {
    const box = await this.stage.boundingBox();
    if (!box) throw new Error("there is no stage");
    const edge = 0.06 * Math.min(box.width, box.height);
    const scale = Math.min((box.width - 2 * edge) / width, (box.height - 2 * edge - 44) / height);
    return {
      x: box.x + box.width / 2 + (x - width / 2) * scale,
      y: box.y + (box.height - 44) / 2 + (y - height / 2) * scale,
    };
  }
}

/** How far two colours are apart. */
export function apart(p: Rgb | null, q: Rgb): number {
  return p ? Math.max(...p.map((v, i) => Math.abs(v - (q[i] ?? 0)))) : 255;
}
