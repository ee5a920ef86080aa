import type { Locator, Page } from "@playwright/test";
import type { Scene } from "../../crate/web/src/api";
import type { Which } from "../../www/src/shell/hook";

/** What a picture looks like, from the engine's own read-back: a capture of the page might be blank and pass. */
export interface Look {
  width: number;
  height: number;
  /** Pixels that hold something. */
  lit: number;
  /** The same for the same picture, to the last bit. */
  hash: string;
  /** The colours of opaque pixels, the most frequent first. */
  colours: string[];
  /** Where the lit pixels lie: left, top, right, bottom. */
  box: [number, number, number, number];
}

type Notices = Window & { said?: string[] };

/** Notes every notice of the page, from its start. */
export async function listen(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const said: string[] = [];
    Object.assign(window, { said });
    const seen = new WeakSet<Element>();
    new MutationObserver(() => {
      for (const toast of document.querySelectorAll(".toast")) {
        if (!seen.has(toast)) said.push(toast.querySelector("p")?.textContent ?? "");
        seen.add(toast);
      }
    }).observe(document, { subtree: true, childList: true });
  });
}

/** The page under test. Actions go through the page as a person's would; only questions go through its hook. */
export class Studio {
  readonly page: Page;
  readonly verdict: Locator;
  readonly time: Locator;
  readonly square: Locator;
  readonly alerts: Locator;
  readonly toasts: Locator;

  constructor(page: Page) {
    this.page = page;
    this.verdict = page.getByTestId("verdict");
    this.time = page.getByRole("slider", { name: "Time", exact: true });
    this.square = page.locator(".locus-square");
    this.toasts = page.getByRole("region", { name: "Notices" });
    this.alerts = this.toasts.getByRole("alert");
  }

  /** Loads the page anew with this fragment, without waiting for what it works out. */
  async open(fragment = "", query = ""): Promise<void> {
    // Another fragment alone would be another document of the same page.
    if (this.page.url() !== "about:blank") await this.page.goto("about:blank");
    await this.page.goto(`./${query}${fragment === "" ? "" : `#${fragment}`}`);
    // Of a family's map, the way of s takes the place of time.
    await this.time.or(this.page.getByRole("slider", { name: "Angle of s around 0" })).waitFor();
  }

  /** Every notice since the page was opened: most leave by themselves, on a slow machine before they are looked for. */
  said(): Promise<string[]> {
    return this.page.evaluate(() => (window as Notices).said ?? []);
  }

  /** The picture is complete. Where the path is automatic it may still change with the plan: `idle` waits for that. */
  async drawn(): Promise<void> {
    await this.page.evaluate(() => window.frond?.drawn());
  }

  /** The locus is complete too, the verdict is about the picture, and nothing is left to work out. */
  async idle(): Promise<void> {
    await this.page.evaluate(() => window.frond?.idle());
  }

  async scene(): Promise<Scene> {
    const scene = await this.page.evaluate(() => window.frond?.scene());
    if (!scene) throw new Error("the page has no hook");
    return scene;
  }

  /** The picture, or the linear one beside it, once it is complete. */
  async look(which: Which = "main"): Promise<Look> {
    await this.drawn();
    return this.page.evaluate(async (which) => {
      if (!window.frond) throw new Error("the page has no hook");
      const { width, height, data } = await window.frond.readPixels(which);
      const box: [number, number, number, number] = [width, height, 0, 0];
      const counts = new Map<number, number>();
      let lit = 0;
      let hash = 0x811c9dc5;
      for (let i = 0; i < width * height; i++) {
        const a = data[4 * i + 3] ?? 0;
        const colour = ((data[4 * i] ?? 0) << 16) | ((data[4 * i + 1] ?? 0) << 8) | (data[4 * i + 2] ?? 0);
        hash = Math.imul(hash ^ ((a << 24) | colour), 0x01000193);
        if (a === 0) continue;
        lit++;
        const x = i % width;
        const y = (i - x) / width;
        box[0] = Math.min(box[0], x);
        box[1] = Math.min(box[1], y);
        box[2] = Math.max(box[2], x);
        box[3] = Math.max(box[3], y);
        if (a === 255) counts.set(colour, (counts.get(colour) ?? 0) + 1);
      }
      const colours = [...counts]
        .sort(([, p], [, q]) => q - p)
        .map(([colour]) => `#${colour.toString(16).padStart(6, "0")}`);
      return { width, height, lit, hash: (hash >>> 0).toString(16), colours, box };
    }, which);
  }

  /** The part of the lit pixels on which the picture and the adaptive cut agree. */
  async likeness(which: Which = "main"): Promise<number> {
    await this.drawn();
    return this.page.evaluate(async (which) => {
      if (!window.frond) throw new Error("the page has no hook");
      const [mine, twin] = [await window.frond.readPixels(which), await window.frond.twin(which)];
      let both = 0;
      let either = 0;
      for (let i = 3; i < twin.data.length; i += 4) {
        const [p, q] = [(mine.data[i] ?? 0) > 0, (twin.data[i] ?? 0) > 0];
        if (p && q) both++;
        if (p || q) either++;
      }
      return either === 0 ? 0 : both / either;
    }, which);
  }

  /** The handle of a waypoint, by number from 1. */
  way(number: number): Locator {
    return this.square.getByRole("slider", { name: new RegExp(`^Waypoint ${number} of `) });
  }

  /** Where a point of the (u, v) plane is on the page. */
  async place(u: number, v: number): Promise<{ x: number; y: number }> {
    await this.square.scrollIntoViewIfNeeded();
    const box = await this.square.boundingBox();
    if (!box) throw new Error("the locus is not on the page");
    return { x: box.x + (box.width * (u + 1)) / 3, y: box.y + (box.height * (2 - v)) / 3 };
  }
}
