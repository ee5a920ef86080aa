import { expect, test } from "./fixture";

test.describe("without a graphics card", () => {
  test.use({ chooses: true });

  test("the processor draws each frame of what plays whole, and the rest complete", async ({
    studio,
    page,
  }) => {
    const asked: string[] = [];
    page.on("request", (request) => asked.push(request.url()));
    await studio.open("a=dragon-3&b=gasket&path=straight&t=0.1");
    await studio.drawn();
    expect(await page.evaluate(() => window.frond?.backend())).toBe("canvas");
    expect(await studio.said()).toEqual([]);
    // No renderer is fetched that would not be used.
    expect(asked.filter((url) => /frond-web(gl2|gpu)/.test(url))).toEqual([]);
    expect(await studio.likeness()).toBeGreaterThanOrEqual(0.999);

    await page.getByRole("button", { name: "Play" }).first().click();
    /** How many of a hundred points along the middle of the lit area are lit, in some moments. */
    const shares = await page.evaluate(async () => {
      const canvas = document.querySelector<HTMLCanvasElement>(".picture canvas");
      const lit: number[] = [];
      for (let moment = 0; canvas && moment < 12; moment++) {
        await new Promise((resolve) => setTimeout(resolve, 120));
        const copy = new OffscreenCanvas(canvas.width, canvas.height);
        const context = copy.getContext("2d");
        context?.drawImage(canvas, 0, 0);
        const { data } = context?.getImageData(0, 0, copy.width, copy.height) ?? { data: [] };
        let count = 0;
        for (let i = 3; i < data.length; i += 4) count += (data[i] ?? 0) > 0 ? 1 : 0;
        lit.push(count / (copy.width * copy.height));
      }
      return lit;
    });
    // Between the two shapes at least a twentieth of the stage is lit.
    expect(Math.min(...shares)).toBeGreaterThan(0.05);
    expect(new Set(shares).size).toBeGreaterThan(4);
  });
});
