/** A class hands in without files: QR codes before a camera, links and words pasted, a link opened, pictures. */
import type { Page } from "@playwright/test";
import { expectClean } from "./axe";
import { expect, test } from "./fixture";

const SHEET = "./#learn/sheet/title=Class%209b&lessons=e1,e12&links=learn%2Fe7&names=link:1%20Where";

/** A pupil's sheet, with a name and words. */
async function pupil(page: Page, name: string): Promise<void> {
  await page.goto("about:blank");
  await page.goto(SHEET);
  await page.getByLabel("Your name").fill(name);
  await page.getByLabel(/What did you find\? .*Two pieces/).fill(`${name} saw it`);
  await page.getByRole("checkbox", { name: "done" }).check();
}

const copied = async (page: Page, button: string) => {
  await page.getByRole("button", { name: button }).click();
  await expect(page.getByText(/copied\./)).toBeVisible();
  return await page.evaluate(() => navigator.clipboard.readText());
};

/** The dark squares of the code that is shown, as the page draws them. */
async function codeShown(page: Page): Promise<{ size: number; path: string }> {
  await page.getByRole("button", { name: "Show QR code" }).click();
  const code = page.getByRole("dialog").getByRole("img");
  await expect(code).toBeVisible();
  const shown = await code.evaluate((svg) => ({
    size: Number(svg.getAttribute("viewBox")?.split(" ")[2]),
    path: svg.querySelector("path")?.getAttribute("d") ?? "",
  }));
  await page.keyboard.press("Escape");
  return shown;
}

/** In place of the camera a picture of codes, one after the other; the test says which. */
async function camera(page: Page): Promise<void> {
  await page.evaluate(() => {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 480;
    const context = canvas.getContext("2d");
    let code = { size: 1, path: "" };
    Object.assign(window, {
      hold(next: typeof code) {
        code = next;
      },
    });
    setInterval(() => {
      if (!context) return;
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.fillStyle = "#fff";
      context.fillRect(0, 0, 480, 480);
      context.setTransform(400 / code.size, 30 / code.size, -30 / code.size, 400 / code.size, 50, 20);
      context.fillStyle = "#111";
      context.fill(new Path2D(code.path));
    }, 50);
    Object.defineProperty(navigator.mediaDevices, "getUserMedia", {
      configurable: true,
      value: async () => canvas.captureStream(),
    });
  });
}

const hold = (page: Page, code: { size: number; path: string }) =>
  page.evaluate((next) => (window as unknown as { hold: (code: typeof next) => void }).hold(next), code);

test.describe(() => {
  // What is kept stays with the window.
  test.use({ alone: true });

  test("answers come by a word, a link and the camera into one table, the later in place of the earlier", async ({
    page,
  }) => {
    await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await pupil(page, "Ada");
    await expectClean(page);
    const ada = await copied(page, "Copy word");
    await page.getByLabel(/What did you find\? .*Two pieces/).fill("Ada saw more");
    const later = await codeShown(page);
    await pupil(page, "Ben");
    const ben = await copied(page, "Copy link");
    await pupil(page, "Cem");
    const cemCode = await codeShown(page);
    const cem = await copied(page, "Copy link");

    await page.goto("about:blank");
    await page.goto("./#learn/class");
    const field = page.getByLabel("Links, words or messages");
    const status = page.getByRole("region", { name: "Answers of your class" }).getByRole("status");
    const row = (name: string) => page.getByRole("row", { name: new RegExp(`^${name}`) });
    await page.evaluate(
      (text) => navigator.clipboard.writeText(text),
      `Ada wrote:\n> ${ada}\nand Ben <${ben}>.`,
    );
    await field.press("Control+V");
    await expect(status.getByText("Ada and Ben added to “Class 9b”.")).toBeVisible();
    await expect(row("Ada")).toContainText("Ada saw it");
    await expect(row("Ben")).toContainText("done");
    // What is typed is taken by a button, and stays where there is nothing in it.
    await field.fill(ada.slice(0, 60));
    await page.getByRole("button", { name: "Add these answers" }).click();
    await expect(status.getByText("One code was cut")).toBeVisible();
    await expect(page.getByRole("row")).toHaveCount(3);

    await camera(page);
    await page.getByRole("button", { name: "Scan QR codes" }).click();
    const dialog = page.getByRole("dialog");
    await dialog.getByLabel("Pupils in the class").fill("3");
    const said = dialog.getByRole("status");
    await hold(page, later);
    await expect(said).toContainText("Ada: 1 of 3 done, in place of earlier answers.");
    await hold(page, cemCode);
    await expect(said).toContainText("Cem: 1 of 3 done.");
    await hold(page, later);
    await expect(said).toContainText("Ada is in the table already.");
    await expect(dialog).toContainText("3 of 3 handed in");
    await expectClean(page);
    await page.keyboard.press("Escape");
    await expect(row("Ada")).toContainText("Ada saw more");

    // The link of a pupil leads to the table that has others of the sheet, and elsewhere to the answers alone.
    await page.goto("about:blank");
    await page.goto(cem);
    await expect(status.getByText("Cem: in the table already.")).toBeVisible();
    await page.getByRole("button", { name: "Clear the table" }).click();
    await expect(page.getByRole("row")).toHaveCount(0);
    await page.reload();
    await expect(page.getByText("This link holds the answers of Cem")).toBeVisible();
    await page.getByRole("button", { name: "For teachers: begin a table with them" }).click();
    await expect(status.getByText("Cem added")).toBeVisible();
  });

  test("codes are read from pictures, and what holds none is told by its name", async ({ page }) => {
    await pupil(page, "Dia");
    await page.getByRole("button", { name: "Show QR code" }).click();
    const picture = await page.getByRole("dialog").screenshot();
    await page.goto("about:blank");
    await page.goto("./#learn/class");
    await page.getByLabel("Files of answers").setInputFiles([
      { name: "dia.png", mimeType: "image/png", buffer: picture },
      { name: "cat.heic", mimeType: "image/heic", buffer: Buffer.from("no picture") },
    ]);
    await expect(page.getByRole("row", { name: /^Dia/ })).toContainText("Dia saw it");
    await expect(page.getByText("cat.heic: This browser cannot open the picture.")).toBeVisible();
  });

  test("a camera that is refused is told, with what to do", async ({ page }) => {
    await page.goto("./#learn/class");
    await page.evaluate(() => {
      Object.defineProperty(navigator.mediaDevices, "getUserMedia", {
        value: async () => {
          throw new DOMException("", "NotAllowedError");
        },
      });
    });
    await page.getByRole("button", { name: "Scan QR codes" }).click();
    await expect(page.getByRole("alert")).toContainText("Allow it beside the address of the page");
    await expect(page.getByRole("button", { name: "Try again" })).toBeVisible();
  });

  test("a sheet has the teacher's order and hides what is right, until its other link shows it", async ({
    page,
  }) => {
    await page.goto("./#learn/class");
    await page.getByRole("checkbox", { name: "Start from anything" }).check();
    await page.getByRole("checkbox", { name: "Two pieces that touch" }).check();
    await page.getByRole("button", { name: /Move up: .*Two pieces/ }).press("Enter");
    await expect(page.getByText(/Two pieces that touch is number 1 of 2\./)).toBeAttached();
    await expect(page.getByRole("button", { name: /Move up: .*Two pieces/ })).toBeFocused();
    await page.getByRole("checkbox", { name: "Lessons do not say yet" }).check();
    await expectClean(page);
    const link = await page.getByLabel(/^The link of this sheet/).inputValue();
    await page.goto("about:blank");
    await page.goto(link);
    await expect(page.getByRole("listitem").first()).toContainText("Two pieces that touch");
    await page.getByLabel("Your name").fill("Eve");
    await page.getByRole("link", { name: /Two pieces that touch/ }).click();
    await page.getByRole("slider", { name: "Scale of piece 1" }).press("ArrowLeft");
    await page.getByRole("button", { name: "Keep my guess" }).click();
    await expect(page.getByText("Your guess is kept: 0.499.")).toBeVisible();
    await expect(page.getByTestId("truth")).toHaveCount(0);
    await page.getByText("For teachers", { exact: true }).click();
    await expect(page.getByRole("button", { name: "Show the answers" })).toHaveCount(0);
    await expect(page.getByRole("heading", { name: "Aim" })).toBeVisible();
    await expect(page.getByRole("heading", { name: "Common mistakes" })).toHaveCount(0);
    // What is kept stays, and whatever way leads to the lesson it hides the same.
    await expect(page.getByRole("slider", { name: "Scale of piece 1" })).toBeDisabled();
    await page.getByRole("link", { name: "All lessons" }).click();
    await page
      .getByRole("link", { name: /Two pieces that touch/ })
      .first()
      .click();
    await expect(page.getByText("Your guess is kept: 0.499.")).toBeVisible();
    await expect(page.getByRole("button", { name: "Show me" })).toHaveCount(0);
    const after = page.getByRole("navigation", { name: "Before and after" });
    await after.getByRole("link", { name: "Back to the class sheet" }).click();
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.getByRole("button", { name: "Save as a file" }).click(),
    ]);
    await expect(page.getByText("your guess is kept")).toBeVisible();
    // The link that is handed in does not tell its pupil either.
    await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    const own = await copied(page, "Copy link");
    const elsewhere = await page.context().browser()?.newContext();
    const other = await elsewhere?.newPage();
    if (!other) throw new Error("no other browser");
    await other.goto(own);
    await expect(other.getByRole("row", { name: /^Eve/ })).toContainText("guessed: 0.499");
    await expect(other.getByRole("row", { name: /^Eve/ })).not.toContainText(/wrong|it is/);
    await elsewhere?.close();
    // What was written is there under the link that shows answers, and the lesson shows them.
    await page.goto("about:blank");
    await page.goto(link.replace("&hide=1", ""));
    await expect(page.getByLabel("Your name")).toHaveValue("Eve");
    await page.getByRole("link", { name: /Two pieces that touch/ }).click();
    await expect(page.getByRole("button", { name: "Show me" })).toBeVisible();
    // The teacher sees all the same whether it was right, and how the class guessed.
    await page.goto("about:blank");
    await page.goto("./#learn/class");
    await page.getByLabel("Files of answers").setInputFiles(await download.path());
    await expect(page.getByRole("row", { name: /^Eve/ })).toContainText("it is: 0.4");
    await page.getByText("How the class guessed").click();
    const counts = page.getByRole("table", { name: /Two pieces that touch: 1 of 1 guessed, 0 right/ });
    await expect(counts.getByRole("row", { name: /^0\.499 1$/ })).toBeVisible();
    await expect(counts.getByRole("row", { name: /^0\.4 right 0$/ })).toBeVisible();
    await expectClean(page);
  });
});
