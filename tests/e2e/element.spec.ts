/** `<frond-view>` on a plain page of another origin: what it shows, says and leaves behind. */
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

interface View extends HTMLElement {
  get t(): number;
  set t(moment: number | string);
  playing: boolean;
  maps(): number[][];
  toPNG(options: { width: number }): Promise<Blob>;
  verdict(): Promise<{ verdict: string }>;
}
type Host = Window & {
  heard: [id: string, type: string, detail: { message?: string }][];
  view(id: string): View;
};

test("a plain page shows morphs in a few lines, and leaves nothing behind", async ({ page, baseURL }) => {
  const server = createServer((_, response) => {
    response
      .setHeader("content-type", "text/html")
      .end(`<!doctype html><html lang="en"><title>A plain page</title>
      <link rel="icon" href="data:," />
      <main><h1>Three of them</h1>
      <frond-view id="fern" a="fern" style="width: 200px"></frond-view>
      <frond-view id="morph" a="dragon-3" b="gasket" path="straight" t="0.5" controls verdict style="width: 300px"></frond-view>
      <frond-view id="wrong" a="hammer" style="width: 200px"></frond-view>
      <frond-view id="frame" src="#figures/e1" style="width: 300px"></frond-view>
      <div style="height: 3000px"></div>
      <frond-view id="far" a="koch" b="dragon" path="straight" style="width: 200px"></frond-view></main>
      <script>
        const heard = [];
        for (const type of ["ready", "verdict", "error"])
          addEventListener(type, ({ target, detail }) => target.id && heard.push([target.id, type, detail]), true);
        Object.assign(window, { heard, view: (id) => document.getElementById(id) });
        // Before it is known what that is.
        document.getElementById("far").t = 0.75;
      </script>
      <script src="${baseURL}frond-view.js"></script>`);
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  await page.goto(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
  const heard = (id: string) =>
    page.evaluate((of) => (window as unknown as Host).heard.filter(([who]) => who === of), id);
  /** How many pixels of the picture are of the shape. */
  const lit = (id: string) =>
    page.evaluate((of) => {
      const canvas = (window as unknown as Host).view(of).shadowRoot?.querySelector("canvas");
      if (!canvas || canvas.hidden) return 0;
      const data = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
      return data.filter((byte, i) => i % 4 === 3 && byte > 0).length;
    }, id);

  await expect.poll(() => lit("fern")).toBeGreaterThan(1000);
  await expect.poll(() => lit("morph")).toBeGreaterThan(1000);
  await expect(page.getByRole("img", { name: "Fern" })).toBeVisible();
  await expect(page.getByText("“a” cannot be “hammer”.")).toBeVisible();
  expect((await heard("wrong")).map(([, type]) => type)).toEqual(["error"]);
  await expect(page.frameLocator("iframe").getByRole("heading", { level: 1 })).toContainText("touch");
  // Its frame is of another origin, into which the check of accessibility below cannot look.
  await page.evaluate(() => document.getElementById("frame")?.remove());

  // It is driven by keys and by the page, and says where it is.
  const time = page.getByRole("slider", { name: "Time" });
  await time.press("End");
  await expect(time).toHaveAttribute("aria-valuetext", "100%");
  await expect(page.getByText("In one piece, proved")).toBeVisible();
  await expect(page.getByRole("img", { name: "Dragon of three on its way to Gasket, 100%" })).toBeVisible();
  await time.press(" ");
  await expect(page.getByRole("button", { name: "Pause" })).toBeVisible();
  await page.getByRole("button", { name: "Pause" }).click();
  const asked = await page.evaluate(async () => {
    const { view } = window as unknown as Host;
    const png = await view("morph").toPNG({ width: 64 });
    view("morph").t = 0.5;
    const { verdict } = await view("morph").verdict();
    return {
      verdict,
      maps: view("morph").maps().length,
      type: png.type,
      image: await createImageBitmap(png),
    };
  });
  expect(asked).toMatchObject({ verdict: "disconnected", maps: 3, type: "image/png" });
  await expectClean(page);

  // One that is moved, or of which an end changes, goes on where it was.
  const kept = await page.evaluate(() => {
    const morph = (window as unknown as Host).view("morph");
    morph.t = 0.25;
    const moments = [morph.t];
    document.querySelector("main")?.prepend(morph);
    moments.push(morph.t);
    morph.setAttribute("b", "koch");
    return [...moments, morph.t];
  });
  expect(kept).toEqual([0.25, 0.25, 0.25]);
  await expect(
    page.getByRole("img", { name: "Dragon of three on its way to Koch curve, 25%" }),
  ).toBeVisible();
  await page.getByRole("button", { name: "Play" }).click();
  await page.evaluate(() =>
    document
      .querySelector("main")
      ?.insertBefore((window as unknown as Host).view("morph"), document.querySelector("h1")),
  );
  await expect(page.getByRole("button", { name: "Pause" })).toBeVisible();
  await page.getByRole("button", { name: "Pause" }).click();
  await page.evaluate(() => (window as unknown as Host).view("morph").setAttribute("b", "gasket"));

  // Off the screen nothing is loaded before one comes near.
  expect(await heard("far")).toEqual([]);
  const moment = () => page.evaluate(() => (window as unknown as Host).view("far").t);
  expect(await moment()).toBe(0.75);
  await page.evaluate(() => {
    (window as unknown as Host).view("far").t = 0.5;
  });
  expect(await moment()).toBe(0.5);
  // As React, Vue and Svelte write what stands in an attribute.
  await page.evaluate(() => {
    (window as unknown as Host).view("far").t = "0.4";
  });
  expect(await moment()).toBe(0.4);
  await page.evaluate(() => {
    (window as unknown as Host).view("far").t = 0.5;
  });
  await page.locator("#far").scrollIntoViewIfNeeded();
  await expect.poll(() => lit("far")).toBeGreaterThan(500);
  expect(await moment()).toBe(0.5);
  // Koch's first map is a third.
  expect((await page.evaluate(() => (window as unknown as Host).view("far").maps()))[0]?.[0]).not.toBeCloseTo(
    1 / 3,
  );
  await page.locator("#fern").scrollIntoViewIfNeeded();

  // What is overtaken while it opens is not shown later on.
  const overtaken = await page.evaluate(async () => {
    const far = (window as unknown as Host).view("far");
    far.setAttribute("a", "tree");
    // The opening has begun, and waits for its module.
    await null;
    far.setAttribute("a", "hammer");
    await new Promise((done) => setTimeout(done, 500));
    try {
      return far.maps();
    } catch (problem) {
      return (problem as { code: string }).code;
    }
  });
  expect(overtaken).toBe("not-ready");

  // The last of many changes wins; nonsense, moves and removals leave nothing but a word.
  await page.evaluate(async () => {
    const fern = (window as unknown as Host).view("fern");
    for (const a of ["koch", "tree", "<b>", "[[1]]", "levy"]) fern.setAttribute("a", a);
    const other = document.body.appendChild(document.createElement("iframe"));
    for (let i = 0; i < 1000; i++) {
      const view = document.createElement("frond-view");
      view.setAttribute("a", i % 2 ? "fern" : "nobody");
      document.body.prepend(view);
      if (i % 100 === 0) await new Promise(requestAnimationFrame);
      if (i % 300 === 0) other.contentDocument?.body.append(view);
      view.remove();
    }
    other.contentDocument?.body.append(fern);
    await new Promise(requestAnimationFrame);
    document.querySelector("h1")?.after(fern);
    other.remove();
  });
  await expect.poll(() => lit("fern")).toBeGreaterThan(500);
  await expect(page.getByRole("img", { name: "Lévy curve" })).toBeVisible();
  expect(page.workers().filter((worker) => worker.url().startsWith("blob:")).length).toBeLessThanOrEqual(2);
  server.close();
  server.closeAllConnections();
});

test("the page of a shape shows it, and leads into the studio", async ({ page }) => {
  await page.goto("./shape/koch.html");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Koch curve");
  await expect(page.locator("frond-view canvas")).toBeVisible();
  await expectClean(page);
  await page.getByRole("link", { name: "Open it in Frond" }).click();
  await expect(page.getByRole("button", { name: "Koch curve" }).first()).toBeVisible();
});
