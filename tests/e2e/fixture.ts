import {
  type Browser,
  test as base,
  type ConsoleMessage,
  type Page,
  type Request,
  type Response,
} from "@playwright/test";
import { listen, Studio } from "./studio";

/**
 * What the software GPU's driver says about its own speed, Chromium about canvases that the tests themselves read more
 * than once and about having no WebGPU, and Playwright about the service worker that it does not let in.
 */
const driver =
  /GL Driver Message|GroupMarkerNotSet|willReadFrequently|No available adapters|registration blocked by Playwright/;

interface Fixtures {
  /** What a test provokes: `test.use({ expected: /device lost/ })`. */
  expected: RegExp | null;
  /** A browser's window of its own, for what would stay with the tab: `test.use({ alone: true })`. */
  alone: boolean;
  /**
   * Whether the map's samples that seem to hold are proved when all is at rest, which keeps every core at work for
   * seconds on each page. Where it is not, each question for proofs is answered at once: none was found.
   */
  proofs: boolean;
  /**
   * Whether the page chooses by itself what draws: the processor, since these browsers have no graphics card. Where it
   * does not, the interface of the project does, as on a machine with a card.
   */
  chooses: boolean;
  quiet: undefined;
  studio: Studio;
}

/** The tab in which one test follows another. */
interface Tab {
  page: Page | null;
}

/**
 * Every test fails that leaves an error or a warning on the page's console, throws past the page, or asks for
 * something that is not there.
 *
 * The tests of a worker share one tab: each begins on an empty page, and loads the studio from the tab's cache.
 */
export const test = base.extend<Fixtures, { tab: Tab }>({
  expected: [null, { option: true }],
  alone: [false, { option: true }],
  proofs: [false, { option: true }],
  chooses: [false, { option: true }],
  tab: [
    // biome-ignore lint/correctness/noEmptyPattern: Playwright reads from it what a fixture needs.
    async ({}, use) => {
      const tab: Tab = { page: null };
      await use(tab);
      await tab.page?.context().close();
    },
    { scope: "worker" },
  ],
  page: async ({ alone, browser, proofs, chooses, tab, viewport }, use, { project }) => {
    const draws = chooses ? null : project.name === "webgpu" ? "webgpu" : "webgl2";
    if (alone || proofs || chooses) {
      const page = await newTab(browser, draws);
      if (!proofs) await findNoProofs(page);
      await use(page);
      await page.context().close();
      return;
    }
    if (!tab.page) {
      tab.page = await newTab(browser, draws);
      await findNoProofs(tab.page);
      // What one test has kept is not offered to the next.
      await tab.page.addInitScript(() => {
        if (location.protocol !== "about:") indexedDB.deleteDatabase("frond");
      });
    }
    const page = tab.page;
    if (viewport) await page.setViewportSize(viewport);
    await use(page);
    await page.evaluate(() => {
      localStorage.clear();
      sessionStorage.clear();
    });
    await page.goto("about:blank");
    await page.unrouteAll();
    await page.mouse.move(0, 0);
    await page.emulateMedia({ colorScheme: "light", reducedMotion: "no-preference" });
  },
  studio: async ({ page }, use) => use(new Studio(page)),
  quiet: [
    async ({ page, expected }, use) => {
      const complaints: string[] = [];
      const complain = (text: string) => {
        if (!driver.test(text) && !expected?.test(text)) complaints.push(text);
      };
      const onConsole = (message: ConsoleMessage) => {
        if (message.type() === "error" || message.type() === "warning") complain(message.text());
      };
      const onError = (error: Error) => complain(String(error));
      const onFailure = (request: Request) => {
        // A request that the page itself gave up is no fault.
        if (request.failure()?.errorText !== "net::ERR_ABORTED") complain(`${request.url()} failed`);
      };
      const onResponse = (response: Response) => {
        if (response.status() >= 400) complain(`${response.url()}: ${response.status()}`);
      };
      page.on("console", onConsole);
      page.on("pageerror", onError);
      page.on("requestfailed", onFailure);
      page.on("response", onResponse);
      await use(undefined);
      page.off("console", onConsole);
      page.off("pageerror", onError);
      page.off("requestfailed", onFailure);
      page.off("response", onResponse);
      if (complaints.length > 0) throw new Error(`the page complained:\n${complaints.join("\n")}`);
    },
    { auto: true },
  ],
});

async function newTab(browser: Browser, draws: string | null): Promise<Page> {
  // What a service worker keeps would go from one test to the next; it has tests of its own.
  const page = await browser.newPage({ serviceWorkers: "block" });
  await listen(page);
  await page.addInitScript((backend) => {
    Object.assign(globalThis, { frondBackend: backend ?? undefined });
  }, draws);
  // Whoever is new here is greeted, which has tests of its own.
  await page.addInitScript(() => {
    if (location.protocol !== "about:" && origin !== "null") localStorage["frond.guide"] ??= "seen";
  });
  return page;
}

/** The workers never see what `www/src/compute/locus` asks them at rest, and all else as ever. */
export async function findNoProofs(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (this: Worker, ...sent: unknown[]) {
      const ask = sent[0] as { type?: string; name?: string; id?: number; args?: { state?: Uint8Array } };
      if (ask?.type !== "run" || ask.name !== "prove") Reflect.apply(postMessage, this, sent);
      else {
        const data = { type: "done", id: ask.id, result: ask.args?.state, milliseconds: 0 };
        setTimeout(() => this.dispatchEvent(new MessageEvent("message", { data })));
      }
    };
  });
}

export { expect } from "@playwright/test";
