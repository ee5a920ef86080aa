import { test as base } from "@playwright/test";
import { Studio } from "./studio";

/**
 * What the software GPU's driver says about its own speed, and Chromium about canvases that the tests themselves read more
 * than once.
 */
const driver = /GL Driver Message|GroupMarkerNotSet|willReadFrequently/;
/** Chromium where it has no WebGPU, each time that it is asked: a page asks once. */
const noWebGpu = /No available adapters/;

/**
 * Every test fails that leaves an error or a warning on the page's console, throws past the page, or asks for
 * something that is not there. A test that provokes one says which: `test.use({ expected: /device lost/ })`.
 */
export const test = base.extend<{ expected: RegExp | null; quiet: undefined; studio: Studio }>({
  expected: [null, { option: true }],
  studio: async ({ page }, use) => use(new Studio(page)),
  quiet: [
    async ({ page, expected }, use) => {
      const complaints: string[] = [];
      let asked = 0;
      const complain = (text: string) => {
        if (noWebGpu.test(text) && ++asked === 1) return;
        if (!driver.test(text) && !expected?.test(text)) complaints.push(text);
      };
      page.on("console", (message) => {
        if (message.type() === "error" || message.type() === "warning") complain(message.text());
      });
      page.on("request", (request) => {
        if (request.isNavigationRequest() && request.frame() === page.mainFrame()) asked = 0;
      });
      page.on("pageerror", (error) => complain(String(error)));
      page.on("requestfailed", (request) => {
        // A request that the page itself gave up is no fault.
        if (request.failure()?.errorText !== "net::ERR_ABORTED") complain(`${request.url()} failed`);
      });
      page.on("response", (response) => {
        if (response.status() >= 400) complain(`${response.url()}: ${response.status()}`);
      });
      await use(undefined);
      if (complaints.length > 0) throw new Error(`the page complained:\n${complaints.join("\n")}`);
    },
    { auto: true },
  ],
});

export { expect } from "@playwright/test";
