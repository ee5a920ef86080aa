import { readFileSync, writeFileSync } from "node:fs";
import { unzipSync } from "fflate";
import { expect, test } from "./fixture";

/** Links that were given out, one a line: the same that the codec's own tests read. */
const given = readFileSync(new URL("../../crate/scene/tests/links.txt", import.meta.url), "utf8")
  .split("\n")
  .filter((line) => line !== "" && !line.startsWith("//"));

test("reloading restores the document and the very same picture", async ({ studio, page }) => {
  await studio.open("a=dragon-3&b=gasket&t=0.3");
  await page.getByRole("radio", { name: "Drawn" }).check();
  await studio.time.focus();
  await studio.time.press("PageUp");
  await page.getByRole("button", { name: "Add waypoint" }).click();
  await page.keyboard.press("Alt+ArrowRight");
  await page.getByRole("button", { name: "Edit the maps of B" }).click();
  const turn = page.getByRole("spinbutton", { name: "Turn", exact: true });
  await turn.fill("1/7");
  await turn.press("Enter");
  await page.getByRole("button", { name: "Done" }).click();
  await expect(page).toHaveURL(/b=maps:/);
  const before = [await studio.scene(), await studio.look()];
  await page.reload();
  await studio.time.waitFor();
  expect([await studio.scene(), await studio.look()]).toEqual(before);
  expect(await studio.said()).toEqual([]);
});

test("the link that is shared opens the same elsewhere", async ({ studio, page, browser }) => {
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await studio.open("a=levy&b=twindragon&t=0.4&colour=address");
  await studio.time.press("ArrowRight");
  await studio.idle();
  await page.getByRole("button", { name: "Share", exact: true }).click();
  const sheet = page.getByRole("dialog", { name: "Share" });
  // Nothing is copied before it is asked for.
  await expect(sheet.getByText("Link copied.")).toHaveCount(0);
  await sheet.getByRole("button", { name: "Copy", exact: true }).click();
  await expect(sheet.getByText("Link copied.")).toBeVisible();
  const shared = await page.evaluate(() => navigator.clipboard.readText());
  const mine = [await studio.scene(), await studio.look()];
  // As it stands; but whoever opens it sees it move once.
  expect(shared).toBe(page.url().replace("#", "?play=once#"));
  await expect(sheet.getByRole("img", { name: "QR code of the link" })).toBeVisible();
  // Another link plays from the beginning.
  await sheet.getByRole("radio", { name: "The beginning" }).check({ force: true });
  await sheet.getByRole("radio", { name: "Loop" }).check({ force: true });
  await sheet.getByRole("button", { name: "Copy", exact: true }).click();
  await expect(sheet.getByText("Link copied.")).toBeVisible();
  const playing = await page.evaluate(() => navigator.clipboard.readText());
  // What is copied for a page is told by its own buttons, and nothing moves for it.
  const embed = sheet.getByRole("button", { name: "Copy embed code" });
  const height = async () => (await sheet.getByRole("status").last().boundingBox())?.height;
  const before = await height();
  await embed.click();
  const told = sheet.getByRole("status").filter({ hasText: "Embed code copied." });
  await expect(told).toBeVisible();
  await expect(sheet.getByText("Link copied.")).toHaveCount(0);
  expect(await height()).toBe(before);
  const [button, words] = [await embed.boundingBox(), await told.boundingBox()];
  expect((words?.y ?? Infinity) - (button?.y ?? 0)).toBeLessThan(100);
  expect(await page.evaluate(() => navigator.clipboard.readText())).toMatch(/^<iframe src=/);
  await sheet.getByRole("button", { name: "Copy element" }).click();
  await expect(sheet.getByText("Element copied.")).toBeVisible();
  // Or it becomes a folder for any host, which draws by itself.
  await sheet.getByRole("button", { name: "Publish" }).click();
  const publish = page.getByRole("dialog", { name: "Publish" });
  await publish.getByLabel("Title").fill("<i>Levy</i>");
  const saved = page.waitForEvent("download");
  await publish.getByRole("button", { name: "Save the folder" }).click();
  const folder = unzipSync(readFileSync(await (await saved).path()));
  expect((await saved).suggestedFilename()).toBe("i-levy-i.zip");
  for (const [name, bytes] of Object.entries(folder)) writeFileSync(test.info().outputPath(name), bytes);
  await page.keyboard.press("Escape");
  await expect(sheet).toBeVisible();
  await page.keyboard.press("Escape");
  // On paper it is complete, with its maps and its link, and nothing of that stays.
  const paper = page.locator("main > section:has(> table)");
  const print = (type: string) => page.evaluate((name) => dispatchEvent(new Event(name)) && 0, type);
  await print("beforeprint");
  await expect(paper.getByRole("link", { includeHidden: true })).toHaveAttribute("href", page.url());
  expect(await paper.locator("tr").count()).toBeGreaterThan(6);
  const inked = await paper.locator("canvas").evaluate((canvas: HTMLCanvasElement) => {
    const { data } = canvas.getContext("2d")?.getImageData(0, 0, canvas.width, canvas.height) ?? { data: [] };
    return data.filter((byte, i) => i % 4 === 3 && byte > 0).length;
  });
  expect(inked).toBeGreaterThan(10_000);
  await print("afterprint");
  await expect(paper).toHaveCount(0);

  const other = await browser.newContext({ viewport: page.viewportSize(), serviceWorkers: "block" });
  // By what draws here: the shades of pieces of pieces differ where the processor draws.
  const draws = await page.evaluate(() => Reflect.get(globalThis, "frondBackend"));
  await other.addInitScript((name) => Object.assign(globalThis, { frondBackend: name }), draws);
  // Whoever was never here, and wants less motion.
  const second = new (
    studio.constructor as new (
      page: Awaited<ReturnType<typeof other.newPage>>,
    ) => typeof studio
  )(await other.newPage());
  await second.page.emulateMedia({ reducedMotion: "reduce" });
  await second.page.goto(shared);
  await second.time.waitFor();
  const welcome = second.page.getByRole("complementary", { name: "Welcome" });
  await expect(welcome).toContainText("Lévy curve turns into Twin-dragon. Made with Frond");
  await welcome.getByRole("button", { name: "Close" }).click();
  expect([await second.scene(), await second.look()]).toEqual(mine);
  // With motion it goes there and back, and rests where it was sent.
  await second.page.emulateMedia({ reducedMotion: "no-preference" });
  await second.page.reload();
  const [low, high] = await second.page.evaluate(
    () =>
      new Promise<[number, number]>((resolve) => {
        let [low, high, began] = [1, 0, false];
        const look = () => {
          const t = window.frond?.scene().t ?? 0.5;
          [low, high] = [Math.min(low, t), Math.max(high, t)];
          const plays = document.querySelector(".time .play")?.getAttribute("aria-label") === "Pause";
          began ||= plays;
          if (began && !plays) resolve([low, high]);
          else requestAnimationFrame(look);
        };
        look();
      }),
  );
  expect(low).toBeLessThan(0.05);
  expect(high).toBeGreaterThan(0.95);
  expect([await second.scene(), await second.look()]).toEqual(mine);
  await second.page.goto(playing);
  await second.page.getByRole("button", { name: "Pause", exact: true }).waitFor();
  await expect.poll(async () => (await second.scene()).t).toBeGreaterThan(0);
  await second.page.emulateMedia({ reducedMotion: "reduce" });
  await second.page.reload();
  await second.time.waitFor();
  await second.idle();
  await expect(second.page.getByRole("button", { name: "Play", exact: true })).toBeVisible();
  await second.page.goto(`file://${test.info().outputPath("index.html")}`);
  await expect(second.page.getByRole("heading", { name: "<i>Levy</i>" })).toBeVisible();
  await second.page.locator("frond-view canvas:not([hidden])").waitFor();
  await other.close();
});

test("the back button leads to the document before", async ({ studio, page }) => {
  await studio.open("a=koch&b=gasket");
  await page.evaluate(() => {
    location.hash = "a=levy&b=gasket&path=straight&t=1";
  });
  await expect.poll(async () => (await studio.scene()).a.preset).toBe("levy");
  await page.goBack();
  await expect.poll(async () => (await studio.scene()).a.preset).toBe("koch");
  expect((await studio.scene()).t).toBe(0);
  await page.goForward();
  await expect.poll(async () => (await studio.scene()).a.preset).toBe("levy");
  // A link that was followed by mistake is undone like anything else.
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  expect((await studio.scene()).a.preset).toBe("koch");
});

test("the back button leads to the tool before, with what was done meanwhile", async ({ studio, page }) => {
  await studio.open("a=koch&b=gasket&path=straight&t=0.5");
  await studio.idle();
  await page.getByRole("navigation", { name: "Places" }).getByRole("link", { name: "Deform" }).click();
  await expect.poll(async () => (await studio.scene()).tool).toBe("deform");
  await page.getByRole("button", { name: "Show me" }).click();
  await expect.poll(async () => (await studio.scene()).deform !== undefined).toBe(true);
  await page.goBack();
  await studio.time.waitFor();
  expect((await studio.scene()).tool ?? "morph").toBe("morph");
  expect((await studio.scene()).deform).toBeDefined();
  await expect(page).not.toHaveURL(/tool=deform/);
  await page.goForward();
  await expect.poll(async () => (await studio.scene()).tool).toBe("deform");
  await page.reload();
  await page.goBack();
  await expect.poll(async () => (await studio.scene()).tool ?? "morph").toBe("morph");
});

test("to the figures and back, nothing is lost", async ({ studio, page }) => {
  await studio.open("a=koch&b=gasket&path=straight&t=0.5");
  const before = [await studio.scene(), await studio.look()];
  await page.getByRole("navigation", { name: "Places" }).getByRole("link", { name: "Figures" }).click();
  await expect(studio.time).toHaveCount(0);
  await page.goBack();
  await studio.time.waitFor();
  expect([await studio.scene(), await studio.look()]).toEqual(before);
});

test("links that were given out show their pictures", async ({ studio, page }) => {
  // What each is, and that all open, tests/api/links.test.ts knows; here one of each way of drawing.
  const drawn = given.filter((link) => /compare=1|colour=density|colour=grid|locus=5|picture=3/.test(link));
  expect(drawn).toHaveLength(6);
  await studio.open();
  for (const link of drawn) {
    await test.step(link, async () => {
      await page.evaluate((fragment) => {
        location.hash = fragment;
      }, link);
      await studio.drawn();
      await expect(studio.alerts).toHaveCount(0);
      // A path that is planned here is written into the address; all else stays as it was sent.
      const sent = (hash: string) =>
        hash.replace(/&check=[^&]*/, "").replace(link.includes("&path=") ? /$^/ : /&path=auto[^&]*/, "");
      await expect(page).toHaveURL((url) => sent(url.hash) === `#${link}`);
      // Where the link zooms in there may be nothing to see.
      if (!link.includes("&view=")) expect((await studio.look()).lit).toBeGreaterThan(1000);
    });
  }
});
