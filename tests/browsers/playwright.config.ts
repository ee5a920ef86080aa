/** Runs the scenarios in the browsers of the table, each of which is a project. */
import { defineConfig } from "@playwright/test";
import { address, siteServer } from "../e2e/site";
import { names } from "./browsers";

export default defineConfig({
  testDir: ".",
  outputDir: "../../target/browsers",
  workers: 2,
  fullyParallel: true,
  // Generous, as in `tests/e2e`. No scenario is about time.
  timeout: 120_000,
  expect: { timeout: 45_000 },
  // One that passes the second time is listed as flaky.
  retries: 1,
  reporter: [["list"], ["../e2e/failed.ts"]],
  use: { baseURL: address },
  projects: names.map((name) => ({ name })),
  ...siteServer,
});
