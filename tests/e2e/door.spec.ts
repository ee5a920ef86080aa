/** Files that come in, however they are given, and maps that go out. */
import { readFile } from "node:fs/promises";
import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

/** Gives the page a file, as a hand would. */
function arrive(
  page: Page,
  how: "drop" | "paste",
  name: string,
  text: string,
  more: [name: string, text: string][] = [],
): Promise<boolean> {
  return page.evaluate(
    ({ how, name, text, more }) => {
      const data = new DataTransfer();
      for (const [title, words] of [[name, text] as const, ...more]) data.items.add(new File([words], title));
      const event =
        how === "drop"
          ? new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true })
          : new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true });
      return !document.body.dispatchEvent(event);
    },
    { how, name, text, more },
  );
}

/** A pair with little to work out: whatever arrives, the page is free for it. */
const PLAIN = "a=gasket&b=koch&path=straight";
/** Files are taken, and keys: what opens a file may come later. */
const listening = (page: Page) =>
  page.waitForFunction(() => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([], "none"));
    return !document.body.dispatchEvent(
      new DragEvent("dragover", { dataTransfer, bubbles: true, cancelable: true }),
    );
  });

const BINARY = "binary { ; two halves\n .5, 0, 0, .5, 0, 0, -.5\n .5, 0, 0, .5, .5, 0, .5\n}\n";
const SPONGE = "sponge (3D) { .4 0 0 0 .4 0 0 0 .4 0 0 0 1  .4 0 0 0 .4 0 0 0 .4 1 0 0 1 }\n";

test("a system of the plane opens in Morph from wherever it is dropped, as one step to undo", async ({
  studio,
  page,
}) => {
  await studio.open(`${PLAIN}&tool=deform`);
  await listening(page);
  expect(await arrive(page, "drop", "whatever.png", BINARY)).toBe(true);
  await expect.poll(async () => (await studio.scene()).a.name).toBe("binary");
  const scene = await studio.scene();
  expect([scene.tool ?? "morph", scene.t, scene.b.preset]).toEqual(["morph", 0, "koch"]);
  await expect.poll(async () => (await studio.said()).join()).toContain("negative");
  await page.getByRole("button", { name: "Open as B instead" }).click();
  await expect.poll(async () => (await studio.scene()).b.name).toBe("binary");
  expect((await studio.scene()).a.preset).toBe("gasket");
  await page.getByRole("button", { name: "Undo", exact: true }).first().click();
  await expect.poll(async () => (await studio.scene()).b.preset).toBe("koch");
  // Colours that a file brings are those of the picture, until they are given back.
  const xform = (color: number, x: number, y: number) =>
    `<xform weight="1" color="${color}" linear="1" coefs=".5 0 0 .5 ${x} ${y}"/>`;
  const xforms = xform(0, 0, 0) + xform(0.5, 0.5, 0) + xform(1, 0.25, -0.5);
  const palette = '<palette count="3" format="RGB">FF0000 00C000 0000FF</palette>';
  await arrive(page, "drop", "three.flame", `<flame name="three">${xforms}${palette}</flame>`);
  const shown = async () => (await studio.look()).colours.slice(0, 3).sort();
  await expect.poll(shown).toEqual(["#0000ff", "#00c000", "#ff0000"]);
  await page.getByText("Colours of the maps", { exact: true }).click();
  await page.getByRole("radio", { name: /^Frond’s/ }).check();
  await expect.poll(shown).not.toContain("#ff0000");
  expect((await studio.scene()).palette).toBeUndefined();
  await page.getByRole("button", { name: "Undo", exact: true }).first().click();
  await page.getByRole("button", { name: "Undo", exact: true }).first().click();
  // All of several files are there to choose from, also where figures were looked at.
  await page.evaluate(() => {
    location.hash = "#figures";
  });
  await expect(page).toHaveTitle(/^Figures/);
  const others: [string, string][] = [
    ["second.ifs", BINARY.replace("binary", "other")],
    ["letter.pdf", "%PDF-1.4\n\0\0"],
  ];
  await arrive(page, "drop", "first.ifs", BINARY, others);
  const dialog = page.getByRole("dialog", { name: "2 files" });
  await expect(dialog).toContainText("This file contains 2 systems.");
  await expect.poll(async () => (await studio.said()).join()).toContain("Not opened: letter.pdf.");
  await dialog.getByRole("button", { name: /other/ }).click();
  await expect.poll(async () => (await studio.scene()).a.name).toBe("other");
});

test("of several systems one is chosen by its picture or its name", async ({ studio, page }) => {
  await studio.open(PLAIN);
  await listening(page);
  const many = Array.from({ length: 14 }, (_, k) => BINARY.replace("binary", `leaf ${k}`)).join("");
  expect(await arrive(page, "paste", "forest.ifs", many + SPONGE)).toBe(true);
  const dialog = page.getByRole("dialog", { name: "forest.ifs" });
  await expect(dialog).toContainText("This file contains 15 systems.");
  await dialog.getByRole("searchbox").fill("leaf 13");
  await expect(dialog.getByRole("listitem")).toHaveCount(1);
  await expect(dialog.getByRole("searchbox")).toBeFocused();
  await expectClean(page);
  await dialog.getByRole("radio", { name: "As both" }).check({ force: true });
  await dialog.getByRole("button", { name: /leaf 13/ }).click();
  await expect.poll(async () => (await studio.scene()).b.name).toBe("leaf 13");
  expect((await studio.scene()).a.name).toBe("leaf 13");
});

test("a system of space opens there, and what is none is refused with its line", async ({ studio, page }) => {
  await studio.open(PLAIN);
  await listening(page);
  await arrive(page, "drop", "bad.ifs", "bad {\n .5 0 0 .5 0 zero\n}");
  await expect.poll(async () => (await studio.said()).join()).toContain('Line 2: "zero" is no number.');
  expect((await studio.scene()).a.preset).toBe("gasket");
  await arrive(page, "drop", "sponge.txt", SPONGE);
  await expect
    .poll(async () => (await studio.said()).join())
    .toContain("sponge replaces the scene, with 2 maps");
  expect((await studio.scene()).tool).toBe("space");
});

/** Two sets, in a root of x⁴ - x³ + x² - x + 1. */
const PAIR =
  "@\n$n=Pair\n$dim=4\n$subspace=[s,0]\ns=$companion([1,-1,1,-1])\n" +
  "A=(s-s^4)^-1*([1,0,0,0]*A|B)\nB=(s-s^4)^-1*([0,1,0,0]*A|[0,0,1,1]*B)\n";
const SOLID = "@\n$dim=3\n$root=Two\nA=2^-1*([1,0,0]|[0,1,0]|[0,0,1]|[0,0,0])*A\nTwo=A|[3,0,0]*A\n";
const TEMPLATE = "@f\n$dim=2\nh=$vector()\nA=2^-1*(1|h)*A\n@:f\n$n=Line\nh=[1,0]\n";

test("programs of IFStile open as what they are: several states, objects of space, or maps of the plane", async ({
  studio,
  page,
}) => {
  await studio.open(PLAIN);
  await listening(page);
  await arrive(page, "drop", "pair.aifs", PAIR);
  await expect
    .poll(async () => (await studio.said()).join())
    .toContain("Pair is now shape A, with 4 maps in 2 states.");
  const { directed, tool, t } = await studio.scene();
  expect([directed?.a.name, directed?.a.states.length, tool ?? "morph", t]).toEqual(["Pair", 2, "morph", 0]);
  await studio.drawn();
  // It is saved as such a program, and opens again.
  await page.getByRole("button", { name: "More for shape A" }).click();
  const download = page.waitForEvent("download");
  await page.getByRole("menuitem", { name: "Save as AIFS" }).click();
  const text = await readFile(await (await download).path(), "utf8");
  await page.getByRole("button", { name: "Undo", exact: true }).first().click();
  await expect.poll(async () => (await studio.scene()).directed).toBeUndefined();
  await arrive(page, "paste", "again.aifs", text);
  await expect.poll(async () => (await studio.scene()).directed?.a.states).toEqual(directed?.a.states);
  await arrive(page, "drop", "line.aifs", TEMPLATE);
  await expect
    .poll(async () => (await studio.said()).join())
    .toContain("1 block is a template of IFStile's finder");
  await arrive(page, "drop", "solid.aifs", SOLID);
  await expect
    .poll(async () => (await studio.said()).join())
    .toContain(
      "solid replaces the scene, in 2 objects. Undo brings it back. It is made of 2 copies of systems",
    );
  await arrive(page, "drop", "endless.aifs", "@\nA=[$,1,1]*A\n");
  await expect
    .poll(async () => (await studio.said()).join())
    .toContain("endless.aifs: Line 2: A list is longer than 4096.");
});

test("maps are exported, and what is saved opens again; a picture holds its document", async ({
  studio,
  page,
}) => {
  // Numbers of as many digits as there are, that none gets lost.
  await studio.open("a=dragon&b=gasket&path=straight&t=0.5");
  await listening(page);
  await page.keyboard.press("t");
  const dialog = page.getByRole("dialog", { name: "Maps as text" });
  await dialog.getByRole("radio", { name: "LaTeX" }).check({ force: true });
  await expect(dialog.getByRole("textbox")).toHaveValue(/begin\{align\*\}/);
  await expectClean(page);
  await dialog.getByRole("radio", { name: "Fractint" }).check({ force: true });
  const download = page.waitForEvent("download");
  await dialog.getByRole("button", { name: "Save .ifs" }).click();
  const file = await download;
  expect(file.suggestedFilename()).toBe("frond-dragon.ifs");
  const text = (await readFile((await file.path()) ?? "")).toString();
  const before = (await studio.scene()).a.maps;
  await arrive(page, "drop", "dragon.ifs", text);
  await expect.poll(async () => (await studio.scene()).a).toEqual({ name: "Dragon", maps: before });

  const picture = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByRole("menuitem", { name: "Save as PNG" }).click();
  const bytes = [...(await readFile((await (await picture).path()) ?? ""))];
  await studio.open(PLAIN);
  await listening(page);
  await page.evaluate((bytes) => {
    const data = new DataTransfer();
    data.items.add(new File([new Uint8Array(bytes)], "dragon.png", { type: "image/png" }));
    document.body.dispatchEvent(
      new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }),
    );
  }, bytes);
  await expect.poll(async () => (await studio.scene()).a.name).toBe("Dragon");
});
