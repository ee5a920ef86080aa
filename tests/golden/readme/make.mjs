// Makes the pictures of README and docs from the running page: `cargo xtask serve` in one terminal, then
// `node tests/golden/readme/make.mjs http://localhost:5173/` in another.
import { fileURLToPath } from "node:url";
import { chromium } from "@playwright/test";

const [, , address = "http://localhost:5173/"] = process.argv;
const path = (name) => fileURLToPath(new URL(`./${name}.png`, import.meta.url));

const browser = await chromium.launch({
  executablePath: process.env["FROND_CHROMIUM"] ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-background-networking", "--enable-unsafe-swiftshader"],
});

async function open(fragment, options = {}) {
  const context = await browser.newContext({
    viewport: { width: 1200, height: 760 },
    colorScheme: "dark",
    ...options,
  });
  const page = await context.newPage();
  // Whoever is new here is greeted.
  await page.addInitScript(() => localStorage.setItem("frond.guide", "seen"));
  await page.goto(`${address}${fragment}`);
  return page;
}

async function studio(fragment, options) {
  const page = await open(fragment, options);
  await page.waitForFunction(() => window.frond !== undefined);
  await page.evaluate(() => window.frond.idle());
  return page;
}

const morph = await studio("");
// A third of the way along the path that the page has found by itself.
const time = morph.getByRole("slider", { name: "Time", exact: true });
await time.focus();
for (let i = 0; i < 4; i++) await time.press("PageUp");
await morph.evaluate(() => window.frond.idle());
await morph.screenshot({ path: path("morph") });
await morph.context().close();

const light = await studio("", { colorScheme: "light", deviceScaleFactor: 1.5 });
const usual = light.viewportSize();
// So tall that the time below lies over nothing of it.
await light.setViewportSize({ ...usual, height: 1200 });
await light.waitForTimeout(500);
await light.evaluate(() => window.frond.idle());
await light.locator("section.locus").screenshot({ path: path("locus") });
await light.setViewportSize(usual);
await light.getByRole("button", { name: /Choose another/ }).first().click();
await light.waitForTimeout(1000);
await light.getByRole("dialog").screenshot({ path: path("gallery") });
await light.context().close();

const evidence = await studio("#v=1&a=dragon-3&b=gasket&t=1");
await evidence.getByTestId("verdict").click();
await evidence.waitForTimeout(1500);
await evidence.evaluate(() => window.frond.idle());
await evidence.screenshot({ path: path("evidence") });
await evidence.context().close();

const tame = await studio("#v=1&a=dragon-3&b=gasket&locus=m:0,0,1&at=0.25,0.6614378277661477");
await tame.waitForTimeout(3000);
await tame.evaluate(() => window.frond.idle());
await tame.screenshot({ path: path("set-m") });
await tame.context().close();

// The middle of the gasket's edge, pulled out: what the tool shows to whoever asks for an example.
const bent = await studio("#v=1&a=gasket&b=dragon-3&tool=deform");
await bent.getByRole("button", { name: "Show me" }).click();
await bent.waitForTimeout(1500);
await bent.evaluate(() => window.frond.idle());
await bent.screenshot({ path: path("deform") });
await bent.context().close();

// The leaf that the tool begins with, fitted, and the maps found in a graph.
const fit = await open("#v=1&a=dragon-3&b=gasket&tool=fit");
await fit.getByText("Other methods with the same amount of data").waitFor({ timeout: 60_000 });
await fit.screenshot({ path: path("fit") });
await fit.context().close();

const graph = await open("#v=1&a=gasket&b=dragon-3&tool=fit&fit=graph:closed,260,0");
await graph.getByLabel("An example").selectOption("table1");
await graph.getByRole("button", { name: "Find the maps" }).click();
await graph.locator("[data-part=took]").waitFor({ timeout: 60_000 });
await graph.getByRole("button", { name: "Assemble", exact: true }).click();
await graph.waitForTimeout(1500);
await graph.screenshot({ path: path("graph") });
await graph.context().close();

/** Space, once its picture is complete. */
async function space(fragment, name, options) {
  const page = await open(fragment, options);
  await page.getByTestId("space-status").getByText("Complete picture", { exact: true }).waitFor({ timeout: 120_000 });
  await page.screenshot({ path: path(name) });
  await page.context().close();
}

await space("#v=1&tool=space", "space");
// In its evening light, before its sky.
const things = Array.from({ length: 13 }, (_, k) => `o:evening-${k}`).join("/");
const natural = `${things}/l:map,-1.05,0.3,0.3,0.35,0.5/f:0.85,0.35,0.8,0.8,0,1/b:e9d2b4`;
const view = (at, x, y, turn) => `k:${at},inout~v${x},${y},-0.4,11,${turn},0.04,0.5`;
const flight = [view(0, 12, 0, -1.57), view(2, 12, 0, -1.62), view(4, 13, 0.4, -1.5)].join("/");
await space(`#v=1&tool=space&space=${natural}/time:6,0,smooth/${flight}&space-at=2`, "scene", {
  colorScheme: "light",
});

// Only the built site has it: `cargo xtask build`, and any server of files for dist/.
const elsewhere = await open("elsewhere.html", { viewport: { width: 1000, height: 900 }, colorScheme: "light" });
await elsewhere.locator("frond-view canvas").first().waitFor();
await elsewhere.waitForTimeout(3000);
await elsewhere.screenshot({ path: path("elsewhere") });
await elsewhere.context().close();

// A fern on its way to a tree, as a film, and the sheet to share from.
const film = await studio("#v=1&a=fern&b=tree");
await film.keyboard.press("x");
await film.getByRole("dialog").waitFor();
await film.waitForTimeout(3000);
await film.screenshot({ path: path("film") });
await film.keyboard.press("Escape");
await film.getByRole("button", { name: "Share" }).click();
await film.getByRole("dialog").waitFor();
await film.waitForTimeout(800);
await film.screenshot({ path: path("share") });
await film.context().close();

const course = await open("#learn", { colorScheme: "light" });
await course.getByRole("heading", { level: 1 }).waitFor();
await course.waitForTimeout(4000);
await course.screenshot({ path: path("learn") });
await course.context().close();

const figure = await open("#figures/7");
await figure.getByRole("heading", { level: 1 }).waitFor();
await figure.waitForTimeout(8000);
await figure.screenshot({ path: path("figure") });
await browser.close();
