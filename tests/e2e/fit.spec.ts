import { readFile } from "node:fs/promises";
import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import {
  apart,
  blank,
  FitTool,
  file,
  GREEN,
  leafPicture,
  noise,
  stalkedPicture,
  twoLeaves,
} from "./fit-tool";
import { expect, test } from "./fixture";
import { png } from "./png";

const source = (page: Page) => page.getByTestId("source").locator("span");
const card = (page: Page) => source(page).first();

test("what is seen first is a leaf with its fit, and the slider changes it", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.open();
  await expect(card(page)).toHaveText("Maple leaf");
  await expect.poll(() => tool.lit()).toBeGreaterThan(10_000);
  await tool.few(24);
  await tool.fitted();
  const { fit } = await tool.scene();
  expect(fit?.numbers).toBe(24);
  const curve = fit?.curve?.curve;
  const numbers = 2 * ((curve?.knots.length ?? 0) + (curve?.edges.filter(Boolean).length ?? 0));
  expect(numbers).toBeGreaterThan(12);
  expect(numbers).toBeLessThanOrEqual(24);
  await expect(tool.figures).toContainText(/Error \(RMS\)\d.*%/);
  const slider = page.getByRole("slider", { name: "Numbers in the fit" });
  await slider.focus();
  await page.keyboard.press("Home");
  await tool.fitted();
  expect((await tool.scene()).fit?.numbers).toBe(12);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await expect.poll(async () => (await tool.scene()).fit?.numbers).toBe(24);
  // What was fitted before is there at once.
  await expect(tool.status).toHaveText(/error, (1|2)\d numbers$/);
  await page.getByRole("button", { name: "Oak leaf" }).click();
  await expect(card(page)).toHaveText("Oak leaf");
  await tool.fitted();
});

test("a fit within so many bytes is told beside others of as many, and a link holds its bytes", async ({
  page,
}) => {
  const tool = new FitTool(page);
  await tool.open();
  await tool.few(24);
  await tool.fitted();
  await page.getByRole("radio", { name: "Limited bytes" }).check({ force: true });
  await page.getByRole("radio", { name: "50", exact: true }).check({ force: true });
  await expect(tool.status).toHaveText(/error, (4|50?)\d? bytes$/, { timeout: 60_000 });
  await expect(page.getByTestId("chart")).toContainText("Fourier", { timeout: 60_000 });
  const { fit } = await tool.scene();
  expect(fit).toMatchObject({ model: "spline", bytes: 50, spline: { name: "Maple leaf" } });
  expect(fit?.curve).toBeUndefined();
  const word = fit?.spline?.word ?? "";
  expect(word.length).toBeLessThanOrEqual(67);
  await expect.poll(() => page.url()).toContain(`&spline=${word}`);
  await page.reload();
  // Nothing is fitted anew: of what it was made from nothing is there.
  await expect(tool.status).toHaveText(/^\d\d bytes$/);
  expect((await tool.scene()).fit?.spline?.word).toBe(word);
  await page.getByRole("button", { name: "Deform it" }).click();
  // What is bent is the same curve: it is not written again.
  await expect.poll(() => page.url()).toContain("&curve-a=spline&");
  const knots = page.getByText(/^closed curve, [1-9]\d* knots/);
  const before = await knots.textContent();
  await page.reload();
  await expect(knots).toHaveText(before ?? "");
});

test("each copy is seen with its arc, by keys and by pointer, and the curve grows out of its knots", async ({
  page,
}) => {
  const tool = new FitTool(page);
  await tool.open();
  await tool.fitted();
  // Rows of the chart come one by one, and each moves what lies below.
  await expect(page.getByTestId("chart")).toContainText("As in the paper");
  const panel = page.getByRole("region", { name: "Its copies" });
  await panel.getByRole("switch", { name: "Show which edge copies which arc" }).check({ force: true });
  const number = panel.getByRole("spinbutton", { name: /^Copy, of/ });
  const words = panel.locator("[data-part=copy]");
  await expect(words).toHaveText(/^This edge copies that arc of \d+ edges: .* times as long/);
  await number.focus();
  await page.keyboard.press("ArrowUp");
  await expect(number).toHaveValue("2");
  // All over the stage the pointer comes near some other copy.
  const box = await page.getByTestId("fit-stage").boundingBox();
  if (!box) throw new Error("there is no stage");
  const seen = new Set<string>();
  for (let i = 1; i < 20; i++) {
    await page.mouse.move(box.x + (box.width * i) / 20, box.y + box.height / 2);
    seen.add(await number.inputValue());
  }
  expect(seen.size).toBeGreaterThan(1);
  const whole = await tool.lit();
  const grow = panel.getByRole("slider", { name: "Steps of growth" });
  await grow.focus();
  await page.keyboard.press("Home");
  await expect(grow).toHaveAttribute("aria-valuetext", "the polygon of knots");
  await expect.poll(() => tool.lit()).not.toBe(whole);
  await panel.getByRole("button", { name: "Show all" }).click();
  await expect(grow).toHaveAttribute("aria-valuetext", "all of it");
  await expectClean(page);
});

test("a photograph becomes a mask, an outline, a fit, a shape of the morph, and a link opens it", async ({
  page,
}) => {
  const tool = new FitTool(page);
  await tool.openFew(24);
  await tool.input.setInputFiles(file(leafPicture, "leaf.png"));
  await expect(card(page)).toHaveText("leaf.png");
  await expect(tool.status).toHaveText(/^Cut out: one part$/);
  // Inside the leaf the picture is as it is, outside it is veiled.
  await expect.poll(async () => apart(await tool.colourAt(0.5, 0.45), GREEN)).toBeLessThan(12);
  await expect(page.getByRole("button", { name: "Fit this outline" })).toBeInViewport();
  await page.getByRole("button", { name: "Fit this outline" }).click();
  await tool.fitted();
  await expect(page.getByTestId("chart")).toContainText("Polyline, best corners");
  await expect(page.getByTestId("chart")).toContainText("Bézier curves");
  await expect(page.getByTestId("chart")).toContainText("As in the paper");
  await expect(page.getByTestId("compare")).toHaveText(/\.$/);
  const fitted = (await tool.scene()).fit?.curve;
  expect(fitted?.name).toBe("leaf");

  await test.step("the link", async () => {
    await page.getByRole("button", { name: "Share", exact: true }).click();
    await page.getByRole("dialog", { name: "Share" }).getByRole("textbox", { name: "Link" }).waitFor();
    const fragment = new URL(page.url()).hash.slice(1);
    await tool.open(fragment);
    await expect(card(page)).toHaveText("leaf");
    await expect(tool.status).toHaveText(/^\d+ numbers$/);
    const again = (await tool.scene()).fit?.curve;
    expect(again).toEqual(fitted);
    await expect.poll(() => tool.lit()).toBeGreaterThan(10_000);
  });

  await test.step("the morph", async () => {
    await page.getByRole("button", { name: "Use as A" }).click();
    await expect(page.getByRole("slider", { name: "Time", exact: true })).toBeVisible();
    const { curves } = await tool.scene();
    expect(curves?.a.name).toBe("leaf");
    expect(curves?.b.preset).toBe("sugar-maple");
    expect(curves?.a.curve.knots.length).toBe(fitted?.curve.knots.length);
    // The shape at the other end had to go, which is said.
    const notice = page.locator(".toasts").getByRole("status");
    await expect(notice).toContainText("Outlines morph only into outlines");
    await notice.getByRole("button", { name: "Undo" }).click();
    expect((await tool.scene()).curves).toBeUndefined();
  });
});

test("a stalk is proposed to be taken off where the fit is used, and stays off", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.openFew(24);
  await tool.input.setInputFiles(file(stalkedPicture, "leaf.png"));
  await page.getByRole("button", { name: "Fit this outline" }).click();
  await tool.fitted();
  const about = source(page).last();
  const whole = await about.textContent();
  const use = page.getByRole("region", { name: "Use" });
  await expect(use.getByRole("button", { name: "Use as B" })).toBeInViewport();
  await expect(use).toContainText(/It has a stalk, \d+% as long as the leaf/);
  await use.getByRole("button", { name: "Remove the stalk" }).click();
  await expect(use).not.toContainText("It has a stalk");
  await expect(about).not.toHaveText(whole ?? "");
  await tool.fitted();
  const without = await about.textContent();

  await use.getByRole("button", { name: "Use as B" }).click();
  await expect(page.getByRole("slider", { name: "Time", exact: true })).toBeVisible();
  await page.getByRole("banner").getByRole("button", { name: "Undo", exact: true }).click();
  await page.getByRole("link", { name: "Fit", exact: true }).click();
  await tool.status.waitFor();
  await expect(about).toHaveText(without ?? "");
  await expect(use).not.toContainText("It has a stalk");
});

test("a brush mends the mask, by mouse and by keys, and strokes are taken back", async ({ page }) => {
  const tool = new FitTool(page);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await tool.openFew(12);
  await tool.input.setInputFiles(file(leafPicture, "leaf.png"));
  await expect(tool.status).toHaveText(/^Cut out: one part$/);
  const box = await tool.stage.boundingBox();
  if (!box) throw new Error("there is no stage");
  const at = await tool.place(180, 190, 360, 400);
  const seen = () => tool.colourAt((at.x - box.x) / box.width, (at.y - box.y) / box.height);
  await expect.poll(async () => apart(await seen(), GREEN)).toBeLessThan(12);

  await test.step("the mouse takes away", async () => {
    await page.getByRole("radio", { name: "Not leaf" }).check({ force: true });
    await page.getByRole("switch", { name: "Do not spread" }).check({ force: true });
    await page.mouse.move(at.x - 40, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x + 40, at.y, { steps: 8 });
    await page.mouse.up();
    await page.mouse.move(box.x + 5, box.y + 5);
    await expect.poll(async () => apart(await seen(), GREEN)).toBeGreaterThan(60);
  });
  await test.step("and the stroke is taken back", async () => {
    await page.getByRole("button", { name: "Undo stroke" }).click();
    await expect.poll(async () => apart(await seen(), GREEN)).toBeLessThan(12);
    await expect(page.getByRole("button", { name: "Undo stroke" })).toBeDisabled();
    await page.getByRole("button", { name: "Redo stroke" }).click();
    await expect.poll(async () => apart(await seen(), GREEN)).toBeGreaterThan(60);
  });
  await test.step("keys put it in again", async () => {
    await page.getByRole("radio", { name: "Leaf", exact: true }).check({ force: true });
    await tool.stage.focus();
    // From where the mouse left it, far off: up and to the left first, then to the place.
    for (let i = 0; i < 60; i++) await page.keyboard.press("ArrowUp");
    for (let i = 0; i < 60; i++) await page.keyboard.press("ArrowLeft");
    // A radius is 3% of half the longer side: 6 pixels, and a key moves half of it.
    for (let i = 0; i < 63; i++) await page.keyboard.press("ArrowDown");
    for (let i = 0; i < 60; i++) await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Space");
    await expect(page.getByRole("button", { name: "Undo stroke" })).toBeEnabled();
    await page.mouse.move(box.x + 5, box.y + 5);
    await page.keyboard.press("Escape");
    await expect.poll(async () => apart(await seen(), GREEN)).toBeLessThan(12);
    await expect(page.getByRole("radio", { name: "Move", exact: true })).toBeChecked();
  });
  await test.step("and Z takes back strokes, not the document", async () => {
    const { numbers } = (await tool.scene()).fit ?? {};
    await page.keyboard.press("z");
    await expect.poll(async () => apart(await seen(), GREEN)).toBeGreaterThan(60);
    expect((await tool.scene()).fit?.numbers).toBe(numbers);
  });
});

test("two leaves: one is taken, and the other can be picked", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.openFew(12);
  await tool.input.setInputFiles(file(twoLeaves, "two.png"));
  await expect(tool.status).toHaveText("Cut out: 2 parts");
  await expect(tool.messages).toContainText(/two|several|2/i);
  const about = source(page).last();
  await expect(about).toContainText("points");
  const first = await about.textContent();
  await page.getByRole("group", { name: "Which part" }).getByRole("radio").nth(1).check({ force: true });
  await expect(about).not.toHaveText(first ?? "");
  await expect(tool.status).toHaveText("Cut out: 2 parts");

  await test.step("one stroke says of all of it that it is not meant, and the header takes it back", async () => {
    await page.getByRole("radio", { name: "Not leaf" }).check({ force: true });
    const [from, to] = [await tool.place(285, 120, 420, 240), await tool.place(345, 120, 420, 240)];
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 6 });
    await page.mouse.up();
    await expect(tool.status).toHaveText("Cut out: one part");
    await page.getByRole("button", { name: "Undo", exact: true }).click();
    await expect(tool.status).toHaveText("Cut out: 2 parts");
  });
});

test("a fit can be stopped, and the best so far is kept", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.open();
  await tool.few(1200);
  await expect(tool.status).toHaveText(/^Fitting, \d+% done/);
  await page.getByRole("button", { name: "Cancel" }).click();
  await expect(tool.status).toHaveText(/^Stopped: \d.* error, \d+ numbers$/);
  await expect(tool.figures).toContainText(/Error \(RMS\)\d.*%/);
  expect((await tool.scene()).fit?.curve?.curve.knots.length).toBeGreaterThan(100);
  await tool.few(12);
  await tool.fitted();
});

test("the paper's fit has gaps that are shown and said, and tied ends have none", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.open();
  await page.getByRole("radio", { name: "As in the paper (collage)" }).check({ force: true });
  await expect(tool.status).toHaveText(/error, 290 numbers$/);
  await expect(page.getByTestId("gaps")).toHaveText(/the widest gap is \d.*%/);
  await page.getByRole("switch", { name: "Tie the ends of the pieces" }).check({ force: true });
  await expect(page.getByTestId("gaps")).toHaveText(/no gaps/);
  await page.getByRole("button", { name: "52 maps" }).click();
  await expect(tool.status).toHaveText(/error, 520 numbers$/);
  await page.getByRole("radio", { name: "anywhere" }).check({ force: true });
  await page.getByRole("radio", { name: "apart" }).check({ force: true });
  // Two numbers fewer for each map: none goes from x to y, or from y to x.
  await expect(tool.status).toHaveText(/error, 416 numbers$/);
  const field = page.getByRole("spinbutton", { name: "Feature points" });
  await field.fill("60");
  await field.press("Enter");
  await expect(tool.problem).toHaveText(/too few for 52 maps/);
});

test("files go in: a drawing, points, noise that is smoothed", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.openFew(24);
  const ring = Array.from({ length: 300 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 300;
    const radius = 40 + 10 * Math.cos(5 * angle) + (i % 2);
    return [radius * Math.cos(angle), radius * Math.sin(angle)] as const;
  });
  const csv = `x,y\n${ring.map(([x, y]) => `${x.toFixed(3)},${y.toFixed(3)}`).join("\n")}\n`;
  await tool.input.setInputFiles(file(csv, "star.csv", "text/csv"));
  await expect(card(page)).toHaveText("star.csv");
  await tool.fitted();
  const rms = async () => Number.parseFloat((await page.getByTestId("rms").textContent()) ?? "");
  const rough = await rms();
  const smoothing = page.getByRole("spinbutton", { name: "Smoothing" });
  await smoothing.fill("0.5");
  await smoothing.press("Enter");
  await expect.poll(rms).not.toBe(rough);
  await tool.fitted();
  expect(await rms()).toBeLessThan(rough);

  const path = ring.map(([x, y], i) => `${i === 0 ? "M" : "L"}${x + 60} ${y + 60}`).join("");
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 120 120"><path id="big" d="${path}Z"/><circle id="small" cx="14" cy="14" r="12"/></svg>`;
  await tool.input.setInputFiles(file(svg, "star.svg", "image/svg+xml"));
  await expect(card(page)).toHaveText("star.svg");
  const choice = page.getByRole("radiogroup", { name: "Which outline" });
  await expect(choice.getByRole("radio", { name: "1: big" })).toBeChecked();
  await expect(choice.locator("path[d]")).toHaveCount(2);
  await choice.getByRole("radio", { name: "1: big" }).press("ArrowRight");
  await expect(choice.getByRole("radio", { name: "2: small" })).toBeChecked();
  await tool.fitted();
});

test("what cannot be fitted is refused with what to try, and nothing is lost", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.openFew(24);
  await tool.fitted();
  const before = (await tool.scene()).fit?.curve;
  const jpeg = Buffer.concat([
    Buffer.from([0xff, 0xd8, 0xff, 0xc0, 0, 17, 8, 0, 90, 0, 120, 3, 1, 0x22, 0, 2, 0x11, 1, 3, 0x11, 1]),
    Buffer.alloc(40),
  ]);
  const huge = Buffer.from(png(1, 1, () => GREEN));
  huge.writeUInt32BE(10_000, 16);
  huge.writeUInt32BE(10_000, 20);
  for (const [given, words] of [
    [file("milk, bread", "notes.png"), /notes\.png|picture|PNG/],
    [file(jpeg, "half.jpg", "image/jpeg"), /half\.jpg|damaged|ends|read/],
    [file(huge, "huge.png"), /megapixel/],
    [file("x,y\n0,0\n1,0\n", "two.csv", "text/csv"), /point/],
    [file(Buffer.alloc(0), "nothing.csv", "text/csv"), /./],
    [
      file(
        '<svg xmlns="http://www.w3.org/2000/svg"><script>alert(1)</script></svg>',
        "script.svg",
        "image/svg+xml",
      ),
      /./,
    ],
    [
      file(
        '<!DOCTYPE svg [<!ENTITY a "haha"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]><svg xmlns="http://www.w3.org/2000/svg"><text>&b;</text></svg>',
        "laughs.svg",
        "image/svg+xml",
      ),
      /./,
    ],
  ] as const) {
    await test.step(given.name, async () => {
      await tool.input.setInputFiles(given);
      const said = page.locator(".toasts .toast").or(tool.problem);
      await expect(said.filter({ hasText: words }).first()).toBeVisible();
      for (const toast of await page.locator(".toasts .toast").all()) {
        await toast
          .getByRole("button", { name: "Dismiss" })
          .click({ timeout: 2000 })
          .catch(() => {});
      }
    });
  }
  expect((await tool.scene()).fit?.curve?.curve.knots.length).toBeGreaterThan(2);
  for (const [given, words] of [
    [file(blank, "blank.png"), /./],
    [file(noise, "noise.png"), /./],
  ] as const) {
    await test.step(given.name, async () => {
      await tool.input.setInputFiles(given);
      await expect(card(page)).toHaveText(given.name);
      await expect(tool.messages).toHaveText(words);
    });
  }
  expect((await tool.scene()).fit?.curve).toBeDefined();
  expect(before).toBeDefined();
});

test("a script in a drawing never runs, and what is beside it is fitted", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.openFew(12);
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" onload="document.title='caught'"><script>document.title='caught'</script><path d="M0 0H90V60L45 90L0 60Z"/></svg>`;
  await tool.input.setInputFiles(file(svg, "house.svg", "image/svg+xml"));
  await expect(card(page)).toHaveText("house.svg");
  expect(await page.title()).toBe("Frond");
  expect(await page.locator("script", { hasText: "caught" }).count()).toBe(0);
});

test("numbers with NaN are left out, and it is said which", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.openFew(12);
  const rows = Array.from({ length: 200 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 200;
    return i === 20 ? "NaN,3" : `${(9 * Math.cos(angle)).toFixed(3)},${(5 * Math.sin(angle)).toFixed(3)}`;
  });
  await tool.input.setInputFiles(file(rows.join("\n"), "gap.csv", "text/csv"));
  await expect(page.locator(".toasts .toast", { hasText: /NaN|line|number/i }).first()).toBeVisible();
});

test("files come out, and say what is seen", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.openFew(24);
  await tool.fitted();
  const saved = async (name: string) => {
    const download = page.waitForEvent("download");
    await page.getByRole("button", { name, exact: true }).click();
    const got = await download;
    expect(got.suggestedFilename()).toBe(`frond-maple-leaf.${name.toLowerCase()}`);
    return readFile(await got.path());
  };
  const json = JSON.parse((await saved("JSON")).toString());
  const { curve } = (await tool.scene()).fit?.curve ?? {};
  expect(json.knots).toEqual(curve?.knots);
  expect(json.edges.length).toBe(curve?.edges.length);
  expect((await saved("SVG")).toString()).toMatch(/^<\?xml|^<svg/);
  expect((await saved("CSV")).toString().trim().split("\n").length).toBeGreaterThan(50);
  const picture = await saved("PNG");
  expect(picture.subarray(1, 4).toString()).toBe("PNG");
  expect(Math.max(picture.readUInt32BE(16), picture.readUInt32BE(20))).toBe(2400);
});

test("a file is dropped on the stage and pasted", async ({ page }) => {
  const tool = new FitTool(page);
  await tool.openFew(12);
  const bytes = [...leafPicture];
  const arrive = (how: "drop" | "paste", called: string) =>
    page.evaluate(
      ({ how, called, bytes }) => {
        const data = new DataTransfer();
        data.items.add(new File([new Uint8Array(bytes)], called, { type: "image/png" }));
        const event =
          how === "drop"
            ? new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true })
            : new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true });
        return !document.body.dispatchEvent(event);
      },
      { how, called, bytes },
    );
  expect(await arrive("drop", "dropped.png")).toBe(true);
  await expect(card(page)).toHaveText("dropped.png");
  expect(await arrive("paste", "pasted.png")).toBe(true);
  await expect(card(page)).toHaveText("pasted.png");
  // Where nothing is found in the picture, the same is offered beside that word.
  const source = page.getByRole("region", { name: "Source" });
  await source.getByRole("button", { name: "Back to dropped.png" }).click();
  await expect(card(page)).toHaveText("dropped.png");
  await expect(tool.status).toHaveText(/^Cut out/);
});

test("axe finds nothing", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  const tool = new FitTool(page);
  await tool.openFew(12);
  await tool.fitted();
  await expect(page.getByTestId("compare")).toBeVisible();
  await test.step("closed curve", () => expectClean(page));
  await test.step("as in the paper", async () => {
    await page.getByRole("radio", { name: "As in the paper (collage)" }).check({ force: true });
    await expect(page.getByTestId("gaps")).toBeVisible();
    await expectClean(page);
  });
  await test.step("cutting out", async () => {
    await tool.input.setInputFiles(file(twoLeaves, "two.png"));
    await expect(tool.status).toHaveText("Cut out: 2 parts");
    await page.getByRole("radio", { name: "Leaf", exact: true }).check({ force: true });
    await expectClean(page);
  });
  await test.step("keys", async () => {
    await page.locator("body").press("?");
    await expect(page.getByRole("dialog")).toBeVisible();
    await expectClean(page);
  });
});
