/** What a page with `<frond-view>` has to show, whoever has made it. */

const TIMEOUT = 60_000;
const VERDICT = "In one piece, proved";
/** Pixels of a shape that a picture has at least. */
const LIT = 1000;

/** Opens it, and fails unless there is a picture of the moment 0.4 with its verdict, and a quiet console. */
export async function look(browser, address, host = {}) {
  const { view = true, output: words = VERDICT, first, also, expected } = host;
  const page = await browser.newPage();
  page.setDefaultTimeout(TIMEOUT);
  const said = [];
  page.on("console", (message) => {
    const [type, text] = [message.type(), message.text()];
    if (["warning", "error", "assert"].includes(type) && !expected?.test(text)) said.push(`${type}: ${text}`);
  });
  page.on("pageerror", (problem) => said.push(`thrown: ${problem.message}`));
  // Browsers ask for it by themselves.
  await page.route("**/favicon.ico", (route) => route.fulfill({ status: 204 }));
  try {
    await page.goto(address);
    await first?.(page);
    await page.waitForFunction(lit, LIT);
    if (view) {
      await page.locator("frond-view").first().getByText(VERDICT).waitFor();
      const t = await page.evaluate(() => document.querySelector("frond-view").t);
      if (t !== 0.4) throw new Error(`it is at ${t}, and was to be at 0.4`);
      const output = page.locator("output");
      if ((await output.count()) > 0) await page.locator("output", { hasText: words }).waitFor();
    }
    await also?.(page);
  } catch (problem) {
    const text = await page.evaluate(() => document.body.innerText).catch(() => "");
    throw new Error([problem.message, ...said, `The page says: ${text.slice(0, 500)}`].join("\n"));
  } finally {
    await page.close();
  }
  if (said.length > 0) throw new Error(["the console says:", ...said].join("\n"));
}

/** Whether a canvas of the page, or of an element in it, shows something. */
function lit(least) {
  const roots = [document, ...[...document.querySelectorAll("frond-view")].map((view) => view.shadowRoot)];
  return roots
    .flatMap((root) => [...(root?.querySelectorAll("canvas") ?? [])])
    .some((canvas) => {
      if (canvas.width * canvas.height === 0) return false;
      // By a canvas of our own: a page that reads its own often is warned.
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", {
        willReadFrequently: true,
      });
      copy.drawImage(canvas, 0, 0);
      const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
      return data.filter((byte, i) => i % 4 === 3 && byte > 0).length > least;
    });
}
