import { expectClean } from "./axe";
import { idsOf, open } from "./figure-pages";
import { expect, test } from "./fixture";

for (const figure of idsOf("in-space")) {
  test(`figure ${figure} shows its shapes, and is clean`, async ({ page }) => {
    await page.emulateMedia({ reducedMotion: "reduce" });
    await open(page, figure);
    const main = page.getByRole("main");
    // What was not printed is called reconstructed; the open question is a page of Frond's own.
    if (figure !== "s9") {
      await expect(main.getByText(/^(reconstructed|by Frond|Frond’s own)$/).first()).toBeVisible();
    }
    const lit = () =>
      page.evaluate(() =>
        [...document.querySelectorAll("canvas")].reduce((most, canvas) => {
          const image = canvas.getContext("2d")?.getImageData(0, 0, canvas.width || 1, canvas.height || 1);
          const count = image ? image.data.filter((value, i) => i % 4 === 3 && value > 0).length : 0;
          return Math.max(most, count);
        }, 0),
      );
    await expect.poll(lit).toBeGreaterThan(500);
    await expectClean(page);
  });
}
