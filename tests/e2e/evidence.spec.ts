import { readFile } from "node:fs/promises";
import type { Certificate } from "../../crate/web/src/api";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

/** Half-way along the straight line the dragon of three is in pieces. */
const BROKEN = "a=dragon-3&b=gasket&path=straight&t=0.5";

test("the verdict tells why, and gives the focus back", async ({ studio, page }) => {
  await studio.open(BROKEN);
  await studio.idle();
  const panel = page.getByRole("region", { name: "In pieces", exact: true });
  await expect(panel).toHaveCount(0);
  await studio.verdict.click();
  await expect(studio.verdict).toHaveAttribute("aria-expanded", "true");
  await expect(panel).toBeVisible();
  await expect(panel).toContainText(
    /Widest gap 6\.\d% of the diameter: between 0\.08\d* and 0\.08\d* in units of the plane/,
  );
  await expect(panel.getByRole("img", { name: "Which pieces meet: 1 with 3" })).toBeVisible();
  await expect(panel).toContainText("{1,3} | {2}");
  await expectClean(page, "#evidence");
  // It follows the picture.
  await studio.time.press("Home");
  await expect(page.getByRole("region", { name: "In one piece, proved" })).toBeVisible();
  await page.getByRole("button", { name: "Close the explanation" }).press("Escape");
  await expect(studio.verdict).toBeFocused();
  await expect(studio.verdict).toHaveAttribute("aria-expanded", "false");
  // Escape closes it from anywhere, and it never lies over the maps that are asked for.
  await studio.verdict.click();
  await page.getByRole("application").first().press("Escape");
  await expect(studio.verdict).toHaveAttribute("aria-expanded", "false");
  await studio.verdict.click();
  await page.getByRole("button", { name: "Edit the maps of A" }).click();
  await expect(studio.verdict).toHaveAttribute("aria-expanded", "false");
});

test("a page that the browser translates keeps its words true", async ({ studio, page }) => {
  await studio.open(BROKEN);
  await studio.idle();
  /** As Chrome does it: an element in the place of each text. */
  const translate = () =>
    page.evaluate(() => {
      const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
      const texts: Text[] = [];
      while (walker.nextNode()) texts.push(walker.currentNode as Text);
      for (const text of texts) {
        if (!text.data.trim() || text.parentElement?.nodeName === "FONT") continue;
        const font = document.createElement("font");
        font.append(text.data.toUpperCase());
        text.replaceWith(font);
      }
    });
  await translate();
  await expect(studio.verdict).toHaveText(/^IN PIECES/);
  await studio.time.press("Home");
  await expect(studio.verdict).toHaveText(/^In one piece, proved/);
  await translate();
  await expect(studio.verdict).toHaveText(/^IN ONE PIECE, PROVED/);
  await studio.time.press("End");
  await studio.time.press("Home");
  await page.evaluate(() => {
    location.hash = "a=koch&b=levy&path=straight&t=0.5";
  });
  await expect(page.getByRole("button", { name: /Koch curve/ }).first()).toContainText("Koch curve");
  await expect(page.getByText("Dragon of three", { exact: true })).toHaveCount(0);
  await expect(page.getByText("DRAGON OF THREE", { exact: true })).toHaveCount(0);
});

test("one piece comes with a reason, and marks on the picture that can be kept", async ({ studio, page }) => {
  await studio.open("a=gasket&b=gasket");
  await studio.idle();
  const marks = page.locator(".overlay :is(.link-ring, .chord)");
  await expect(marks).toHaveCount(0);
  await studio.verdict.click();
  await expect(page.getByTestId("evidence-reason")).toContainText(/\w+/);
  await expect(marks.first()).toBeAttached();
  await page.getByRole("switch", { name: "Keep the marks on the picture" }).check();
  await page.getByRole("button", { name: "Close the explanation" }).click();
  await expect(marks.first()).toBeAttached();
});

test("a proof of pieces is checked and can be taken away", async ({ studio, page }) => {
  // No pixel shows this gap: the words, their reason and the strip speak of it all the same.
  await studio.open("a=terdragon&b=gasket&path=straight&t=0.995");
  await studio.idle();
  await expect(studio.verdict).toHaveText(
    "In piecesgap 0.056%, under 1/600 of its size, by Frond’s own bounds",
  );
  await expect(studio.time).toHaveAttribute(
    "aria-valuetext",
    /in pieces, gap 0\.056%, under 1\/600 of its size, by Frond’s own bounds$/,
  );
  await studio.verdict.click();
  const panel = page.getByRole("region", { name: /^In pieces/ });
  await expect(panel).toContainText("narrower than 1/600 of the diameter");
  await expect(panel).toContainText("Widest gap 0.056% of the diameter");
  await page.getByRole("button", { name: "Check the proof" }).click();
  await expect(page.getByText(/^Verified in exact arithmetic: [\d,]+ pairs? of pieces/)).toBeVisible();
  // Only now is it called proved.
  await expect(studio.verdict).toHaveText("In pieces, provedgap 0.056%, under 1/600 of its size");
  const coming = page.waitForEvent("download");
  await page.getByRole("button", { name: "Download the proof" }).click();
  const download = await coming;
  expect(download.suggestedFilename()).toBe("frond-proof.json");
  const proof = JSON.parse(await readFile(await download.path(), "utf8")) as Certificate;
  expect(proof.maps).toHaveLength(3);
  expect(new Set(proof.side)).toEqual(new Set([0, 1]));
  expect(proof.pairs.length).toBeGreaterThan(0);
  // It is about these maps only.
  await studio.time.focus();
  await studio.time.press("ArrowLeft");
  await expect(page.getByRole("button", { name: "Check the proof" })).toBeVisible();
});
