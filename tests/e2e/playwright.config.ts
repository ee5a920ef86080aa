import { existsSync } from "node:fs";
import { defineConfig, devices } from "@playwright/test";
import { address, siteServer } from "./site";

/** `cargo xtask` says where Chromium is; without it, the places where systems put it. */
const chromium =
  process.env["FROND_CHROMIUM"] ??
  ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find((path) =>
    existsSync(path),
  );

/** The same in crate/render/webdriver.json, for the tests of the shaders. */
const flags = [
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-quic",
  "--disable-sync",
  "--no-first-run",
  // Chromium will not sandbox itself as root, and only this repository's own pages are opened.
  "--no-sandbox",
  // No network but the site itself: what is loaded from elsewhere fails, and a test with it.
  "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1, EXCLUDE localhost",
];

/**
 * A software GPU, so that both backends are there on any machine and draw the same picture on all. WebGL2 alone has it:
 * the page around the picture is quicker without.
 */
const webgl2 = ["--enable-unsafe-swiftshader"];
const webgpu = [
  "--enable-unsafe-webgpu",
  "--use-webgpu-adapter=swiftshader",
  "--enable-features=Vulkan",
  "--use-vulkan=swiftshader",
  "--use-angle=swiftshader",
];

function launch(backend: string[]) {
  return { args: [...flags, ...backend], ...(chromium === undefined ? {} : { executablePath: chromium }) };
}

export default defineConfig({
  testDir: ".",
  outputDir: "../../target/e2e",
  // A software GPU takes every core it finds: two at once are a seventh to a fifth quicker on two cores, three are not.
  workers: 2,
  fullyParallel: true,
  // Generous: software draws, and the machine may have other things to do. No test is about time.
  timeout: 180_000,
  expect: { timeout: 45_000 },
  // A test that passes the second time is listed as flaky.
  retries: process.env["CI"] === undefined ? 0 : 1,
  forbidOnly: process.env["CI"] !== undefined,
  reporter: [["list"], ["./failed.ts"]],
  use: {
    ...devices["Desktop Chrome"],
    baseURL: address,
    viewport: { width: 1280, height: 800 },
    screenshot: "only-on-failure",
    // Keeping one of every test takes time from all of them.
    trace: { mode: "on-first-retry", screenshots: false },
  },
  projects: [
    { name: "webgl2", testIgnore: "**/*.phone.spec.ts", use: { launchOptions: launch(webgl2) } },
    {
      name: "webgpu",
      // What hangs on what draws; all else is tried once.
      testIgnore: "**/*.phone.spec.ts",
      grep: /@webgpu/,
      use: { launchOptions: launch(webgpu) },
    },
    {
      name: "phone",
      testMatch: "**/*.phone.spec.ts",
      use: {
        launchOptions: launch(webgl2),
        viewport: { width: 390, height: 844 },
        deviceScaleFactor: 2,
        hasTouch: true,
        isMobile: true,
      },
    },
  ],
  ...siteServer,
});
