import { readFile } from "node:fs/promises";
import type { ConnectedCertificate } from "../../crate/web/src/api";
import { expect, test } from "./fixture";
import type { Studio } from "./studio";

/** Koch's curve as a course writes it; a to f of each map, and what is not 0 already. */
const KOCH = [
  { a: "1/3", d: "1/3", e: "0", f: "0" },
  { a: "cos(60°)/3", b: "-sin(60°)/3", c: "sin(60°)/3", d: "cos(60°)/3", e: "1/3", f: "0" },
  { a: "cos(60°)/3", b: "sin(60°)/3", c: "-sin(60°)/3", d: "cos(60°)/3", e: "1/2", f: "√3/6" },
  { a: "1/3", d: "1/3", e: "2/3", f: "0" },
] as const;
const NAMES = {
  a: "New x from x, a",
  b: "New x from y, b",
  c: "New y from x, c",
  d: "New y from y, d",
  e: "Move across, e",
  f: "Move up, f",
} as const;
/** Four maps that are nothing yet. */
const ROUGH =
  "a=maps:.25,0,0,.25,0,0;.25,0,0,.25,.25,0;.25,0,0,.25,.5,.25;.25,0,0,.25,.75,0&b=gasket&path=straight";

async function type(studio: Studio, map: number, numbers: Partial<Record<keyof typeof NAMES, string>>) {
  const head = studio.page.locator(".side").getByRole("button", { name: new RegExp(`Map ${map}: `) });
  if ((await head.getAttribute("aria-expanded")) === "false") await head.click();
  for (const [name, text] of Object.entries(numbers)) {
    const field = studio.page.getByRole("spinbutton", { name: NAMES[name as keyof typeof NAMES] });
    await field.fill(text);
    await field.press("Enter");
    await expect(field).toHaveAttribute("data-settled", "true");
  }
}

test("Koch's curve, typed with thirds and cosines, is proved about these numbers", async ({
  studio,
  page,
}) => {
  await studio.open(ROUGH);
  await page.locator("body").press("e");
  await page.getByRole("radio", { name: "Six numbers" }).check();
  for (const [k, numbers] of KOCH.entries()) await type(studio, k + 1, numbers);
  const { a } = await studio.scene();
  expect(new Set(a.exact)).toEqual(new Set(["1/3", "2/3", "1/6", "sqrt(3)/6"]));
  await page.getByRole("button", { name: "Done" }).click();
  await expect(studio.verdict).toHaveText(/^In one piece, proved/);

  await test.step("dimension and neighbours follow, and the proof is about the exact numbers", async () => {
    await studio.verdict.click();
    const panel = page.getByRole("region", { name: "In one piece, proved" });
    await expect(panel).toContainText("Exact numbers");
    await panel.getByText("Dimension and neighbours").click();
    await expect(panel.getByTestId("analysis")).toContainText("log 4 / log 3 ≈ 1.261860, proved");
    await expect(panel.getByTestId("analysis")).toContainText("holds, proved");
    await panel.getByRole("button", { name: "Check the proof" }).click();
    await expect(panel).toContainText("The proof is about the exact numbers.");
    const waits = page.waitForEvent("download");
    await panel.getByRole("button", { name: "Download the proof" }).click();
    const text = await readFile(await (await waits).path(), "utf8");
    const { exact, links } = JSON.parse(text) as ConnectedCertificate;
    // sqrt(3) solves x² = 3.
    expect(exact?.polynomial).toEqual(["-3", "0", "1"]);
    expect(links.length).toBeGreaterThanOrEqual(3);
  });

  await test.step("the link brings the numbers back, and a step makes decimals of what it changes", async () => {
    await expect.poll(() => page.url()).toContain("a-exact=");
    const fragment = new URL(page.url()).hash.slice(1);
    await studio.open(fragment);
    await expect(studio.verdict).toHaveText(/^In one piece, proved/);
    await page.locator("body").press("e");
    await page.getByRole("radio", { name: "Six numbers" }).check();
    const shift = page.getByRole("spinbutton", { name: NAMES.e });
    await page
      .locator(".side")
      .getByRole("button", { name: /Map 4: / })
      .click();
    await expect(shift).toHaveValue("2/3");
    await shift.press("ArrowUp");
    await expect(shift).not.toHaveValue("2/3");
    expect((await studio.scene()).a.exact).not.toContain("2/3");
    expect((await studio.scene()).a.exact).toContain("1/3");
  });
});

test("turn and stretch are exact together", async ({ studio, page }) => {
  await studio.open(ROUGH);
  await page.locator("body").press("e");
  const field = (name: string) => page.getByRole("spinbutton", { name });
  for (const [name, text] of [
    ["Stretch across", "1/3"],
    ["Stretch up", "1/3"],
    ["Turn", "60"],
  ] as const) {
    await field(name).fill(text);
    await field(name).press("Enter");
    await expect(field(name)).toHaveAttribute("data-settled", "true");
  }
  const { a } = await studio.scene();
  expect(new Set(a.exact)).toEqual(new Set(["1/6", "sqrt(3)/6"]));
  expect(a.maps[0]).toEqual([1 / 6, -0.28867513459481287, 0.28867513459481287, 1 / 6, 0, 0]);
});

test("decimals that come near to numbers can be taken for these", async ({ studio, page }) => {
  const third = 1 / 3;
  const cells = [0, third, 2 * third].map((x) => `${third},0,0,${third},${x},0`).join(";");
  await studio.open(`a=maps:${cells}&b=gasket&path=straight`);
  await expect(studio.verdict).toHaveText(/^No gap seen/);
  await studio.verdict.click();
  await page.getByRole("button", { name: "Use the exact values" }).click();
  await expect(studio.verdict).toHaveText(/^In one piece, proved/);
  expect((await studio.scene()).a.exact).toEqual(["1/3", "2/3"]);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await expect(studio.verdict).toHaveText(/^No gap seen/);
});

test("the boundary of a tile opens as a shape of several states", async ({ studio, page }) => {
  await studio.open("a=gosper&b=gasket&path=straight");
  await studio.idle();
  await studio.verdict.click();
  await page.getByText("Dimension and neighbours").click();
  await expect(page.getByTestId("analysis")).toContainText("1.129150, proved");
  await page.getByRole("button", { name: "Open the boundary" }).click();
  const { directed } = await studio.scene();
  expect(directed?.a.name).toBe("Boundary of Gosper island");
  // Six neighbours, and the whole.
  expect(directed?.a.states.length).toBe(7);
  await studio.drawn();
  expect((await studio.look()).lit).toBeGreaterThan(500);
  await page.getByRole("button", { name: "Undo", exact: true }).first().click();
  expect((await studio.scene()).directed).toBeUndefined();
});
