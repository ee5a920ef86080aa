/** WebKitGTK, by its own driver, with as much of Playwright's page as the scenarios use. */
import { type ChildProcess, spawn } from "node:child_process";
import { once } from "node:events";
import type { AddressInfo } from "node:net";
import { createServer } from "node:net";
import type { Readable } from "node:stream";
import { setTimeout as sleep } from "node:timers/promises";
import type { Page } from "@playwright/test";
import { address } from "../e2e/site";
import { find, matching, type Step } from "./find";
import type { Opened } from "./opened";

/** How often the page is asked again whether something is there, and for how long. */
const EVERY_MS = 200;
const PATIENCE_MS = 60_000;

/** What WebDriver calls an element in its answers. */
const ELEMENT = "element-6066-11e4-a52e-4f735466cecf";

/** Keys as WebDriver writes them. */
const KEYS: Record<string, string> = {
  Enter: "\ue007",
  Escape: "\ue00c",
  Space: " ",
  End: "\ue010",
  Home: "\ue011",
  ArrowLeft: "\ue012",
  ArrowUp: "\ue013",
  ArrowRight: "\ue014",
  ArrowDown: "\ue015",
};

/** Starts the driver, on a display of its own, which this browser needs. */
export async function openWebKit(program: string): Promise<Opened> {
  const display = spawn("Xvfb", ["-displayfd", "3", "-screen", "0", "1300x900x24", "-nolisten", "tcp"], {
    stdio: ["ignore", "ignore", "ignore", "pipe"],
  });
  const [number] = (await once(display.stdio[3] as Readable, "data")) as [Buffer];
  const port = await freePort();
  const driver = spawn("WebKitWebDriver", [`--port=${port}`], {
    env: {
      ...process.env,
      DISPLAY: `:${String(number).trim()}`,
      WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: "1",
    },
    stdio: "ignore",
  });
  const end = () => {
    driver.kill();
    // With it goes a browser that has not ended by itself.
    display.kill();
  };
  process.once("exit", end);
  const server = `http://127.0.0.1:${port}`;
  await answers(server, driver);
  return {
    newPage: async () => (await WebKitPage.open(server, program)) as unknown as Page,
    listen: (page) => (page as unknown as WebKitPage).tell(),
    close: async () => end(),
  };
}

async function freePort(): Promise<number> {
  const server = createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = server.address() as AddressInfo;
  server.close();
  return port;
}

async function answers(server: string, driver: ChildProcess): Promise<void> {
  while (driver.exitCode === null) {
    if (await fetch(`${server}/status`).catch(() => null)) return;
    await sleep(EVERY_MS);
  }
  throw new Error("WebKitWebDriver ended");
}

type Heard = { type: "console" | "pageerror"; text: string };
type Window_ = Window & { heard?: Heard[] };

/** Of what the page says, it hears what comes after the document has been read: this driver tells nothing itself. */
function listen(): void {
  const window_ = window as Window_;
  if (window_.heard) return;
  const heard: Heard[] = [];
  window_.heard = heard;
  for (const kind of ["error", "warn"] as const) {
    const say = console[kind];
    console[kind] = (...words: unknown[]) => {
      heard.push({ type: "console", text: words.join(" ") });
      say(...words);
    };
  }
  addEventListener("error", ({ message }) => heard.push({ type: "pageerror", text: message }));
  addEventListener("unhandledrejection", ({ reason }) =>
    heard.push({ type: "pageerror", text: String(reason) }),
  );
  addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI }) =>
    heard.push({ type: "pageerror", text: `the policy ${violatedDirective} refused ${blockedURI}` }),
  );
}

class WebKitPage {
  readonly #session: string;
  readonly #first: string[] = [];
  readonly #listeners: { [event: string]: (it: unknown) => void } = {};
  #url = "about:blank";

  static async open(server: string, binary: string): Promise<WebKitPage> {
    const options = { binary, args: ["--automation"] };
    const capabilities = {
      alwaysMatch: {
        pageLoadStrategy: "normal",
        timeouts: { script: PATIENCE_MS },
        "webkitgtk:browserOptions": options,
      },
    };
    const { sessionId } = (await request("POST", `${server}/session`, { capabilities })) as {
      sessionId: string;
    };
    const page = new WebKitPage(`${server}/session/${sessionId}`);
    await page.ask("POST", "/window/rect", { x: 0, y: 0, width: 1280, height: 838 });
    return page;
  }

  constructor(session: string) {
    this.#session = session;
  }

  ask(method: string, path: string, body?: object): Promise<unknown> {
    return request(method, this.#session + path, body);
  }

  context() {
    return { close: () => this.ask("DELETE", "") };
  }

  url(): string {
    return this.#url;
  }

  on(event: string, listener: (it: unknown) => void): void {
    this.#listeners[event] = listener;
  }

  off(event: string): void {
    delete this.#listeners[event];
  }

  async addInitScript(script: () => void): Promise<void> {
    this.#first.push(`(${script})();`);
  }

  async goto(url: string): Promise<void> {
    await this.tell();
    if (url !== "about:blank" && this.#url === "about:blank") {
      // What is to be kept before the page begins: on a text of the same origin.
      await this.ask("POST", "/url", { url: new URL("licenses.txt", new URL(url, address)).href });
      await this.#begin();
    }
    this.#url = new URL(url, address).href;
    await this.ask("POST", "/url", { url: this.#url });
    await this.#begin();
  }

  async reload(): Promise<void> {
    await this.tell();
    await this.ask("POST", "/refresh", {});
    await this.#begin();
  }

  async #begin(): Promise<void> {
    const script = [`(${listen})();`, ...this.#first].join("\n");
    await this.ask("POST", "/execute/sync", { script, args: [] });
  }

  /** Tells what the page has said so far. */
  async tell(): Promise<void> {
    const heard = await this.evaluate(() => (window as Window_).heard?.splice(0) ?? []);
    for (const { type, text } of heard) {
      const message = type === "console" ? { type: () => "error", text: () => text } : new Error(text);
      this.#listeners[type]?.(message);
    }
  }

  /** As Playwright's: the function crosses to the page as its text, what it takes and gives as JSON. */
  async evaluate<T, A>(ask: (it: A) => T | Promise<T>, it?: A): Promise<T> {
    const script = `const end = arguments[arguments.length - 1];
      Promise.resolve().then(() => (${ask})(arguments[0])).then(
        (value) => end({ value }),
        (error) => end({ error: String(error) }),
      );`;
    const answer = (await this.ask("POST", "/execute/async", { script, args: [it ?? null] })) as {
      value: T;
      error?: string;
    };
    if (answer.error !== undefined) throw new Error(answer.error);
    return answer.value;
  }

  getByRole(role: string, { name, exact }: { name?: string | RegExp; exact?: boolean } = {}): Place {
    return new Place(this, [[byRole(role, name, exact)]]);
  }

  getByTestId(text: string): Place {
    return new Place(this, [[{ by: "test", text }]]);
  }

  getByText(text: string | RegExp, { exact }: { exact?: boolean } = {}): Place {
    return new Place(this, [[{ by: "text", match: matching(text, exact) }]]);
  }

  getByLabel(text: string | RegExp): Place {
    return new Place(this, [[{ by: "label", match: matching(text) }]]);
  }

  locator(text: string): Place {
    return new Place(this, [[{ by: "css", text }]]);
  }

  readonly keyboard = {
    press: async (key: string) => {
      const value = KEYS[key] ?? key;
      const actions = [
        { type: "keyDown", value },
        { type: "keyUp", value },
      ];
      await this.ask("POST", "/actions", { actions: [{ type: "key", id: "keys", actions }] });
    },
  };

  readonly mouse = {
    move: (x: number, y: number) =>
      this.#point({ type: "pointerMove", x: Math.round(x), y: Math.round(y), duration: 0 }),
    down: () => this.#point({ type: "pointerDown", button: 0 }),
    up: () => this.#point({ type: "pointerUp", button: 0 }),
  };

  async #point(action: object): Promise<void> {
    const parameters = { pointerType: "mouse" };
    const mouse = { type: "pointer", id: "mouse", parameters, actions: [action] };
    await this.ask("POST", "/actions", { actions: [mouse] });
  }
}

const byRole = (role: string, name?: string | RegExp, exact?: boolean): Step =>
  name === undefined ? { by: "role", role } : { by: "role", role, match: matching(name, exact) };

/** Where elements are, as Playwright's locator: it is looked for anew each time. */
class Place {
  readonly #page: WebKitPage;
  readonly ways: Step[][];

  constructor(page: WebKitPage, ways: Step[][]) {
    this.#page = page;
    this.ways = ways;
  }

  #then(step: Step): Place {
    return new Place(
      this.#page,
      this.ways.map((way) => [...way, step]),
    );
  }

  locator(text: string): Place {
    return this.#then({ by: "css", text });
  }

  getByRole(role: string, { name, exact }: { name?: string | RegExp; exact?: boolean } = {}): Place {
    return this.#then(byRole(role, name, exact));
  }

  getByText(text: string | RegExp, { exact }: { exact?: boolean } = {}): Place {
    return this.#then({ by: "text", match: matching(text, exact) });
  }

  first(): Place {
    return this.#then({ by: "first" });
  }

  or(other: Place): Place {
    return new Place(this.#page, [...this.ways, ...other.ways]);
  }

  async #all(): Promise<object[]> {
    const script = `return (${find})(arguments[0]);`;
    return (await this.#page.ask("POST", "/execute/sync", { script, args: [this.ways] })) as object[];
  }

  /** The element, once it is there. */
  async #one(): Promise<object> {
    for (const end = Date.now() + PATIENCE_MS; Date.now() < end; await sleep(EVERY_MS)) {
      const [one] = await this.#all();
      if (one) return one;
    }
    throw new Error(`there is no ${JSON.stringify(this.ways)}`);
  }

  async waitFor(): Promise<void> {
    await this.#one();
  }

  async count(): Promise<number> {
    return (await this.#all()).length;
  }

  async evaluate<T, A>(ask: (element: Element, it: A) => T, it?: A): Promise<T> {
    const args = [await this.#one(), it ?? null];
    return (await this.#page.ask("POST", "/execute/sync", {
      script: `return (${ask})(...arguments);`,
      args,
    })) as T;
  }

  textContent(): Promise<string | null> {
    return this.evaluate((element) => element.textContent);
  }

  getAttribute(name: string): Promise<string | null> {
    return this.evaluate((element, name) => element.getAttribute(name), name);
  }

  async boundingBox(): Promise<{ x: number; y: number; width: number; height: number }> {
    return this.evaluate((element) => {
      const { x, y, width, height } = element.getBoundingClientRect();
      return { x, y, width, height };
    });
  }

  async focus(): Promise<void> {
    await this.evaluate((element) => (element as HTMLElement).focus());
  }

  async press(key: string): Promise<void> {
    await this.focus();
    await this.#page.keyboard.press(key);
  }

  async click(): Promise<void> {
    const element = (await this.#one()) as { [ELEMENT]: string };
    await this.#page.ask("POST", `/element/${element[ELEMENT]}/click`, {});
  }

  async fill(value: string): Promise<void> {
    await this.evaluate((element, value) => {
      const input = element as HTMLInputElement;
      input.focus();
      input.value = value;
      input.dispatchEvent(new InputEvent("input", { bubbles: true }));
    }, value);
  }

  async setInputFiles(file: { name: string; mimeType: string; buffer: Buffer }): Promise<void> {
    const { name, mimeType: type } = file;
    await this.evaluate(
      (element, { name, type, base64 }) => {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        const files = new DataTransfer();
        files.items.add(new File([bytes], name, { type }));
        (element as HTMLInputElement).files = files.files;
        element.dispatchEvent(new Event("change", { bubbles: true }));
      },
      { name, type, base64: file.buffer.toString("base64") },
    );
  }
}

async function request(method: string, url: string, body?: object): Promise<unknown> {
  const signal = AbortSignal.timeout(PATIENCE_MS);
  const response = await fetch(url, { method, signal, ...(body ? { body: JSON.stringify(body) } : {}) });
  const { value } = (await response.json()) as { value: unknown };
  if (response.ok) return value;
  const { error, message } = value as { error: string; message: string };
  throw new Error(`${method} ${url.replace(/.*\/session\/[^/]*/, "")}: ${error}. ${message}`);
}
