/** The table of the browsers that the scenarios run in. */
import { existsSync } from "node:fs";
import { chromium, firefox } from "@playwright/test";
import type { Opened } from "./opened";
import { openWebKit } from "./webkit";

interface Row {
  name: string;
  /** The environment names the program, or it is at the first of these places. */
  variable: string;
  places: string[];
  open(program: string): Promise<Opened>;
}

const viewport = { width: 1280, height: 800 };

const rows: Row[] = [
  {
    // Tests of this browser alone are in `tests/e2e`. Here it shows whether a scenario itself is at fault.
    name: "chromium",
    variable: "FROND_CHROMIUM",
    places: ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"],
    open: async (executablePath) => {
      const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
      return { newPage: () => browser.newPage({ viewport }), close: () => browser.close() };
    },
  },
  {
    name: "firefox",
    variable: "FROND_FIREFOX",
    places: [
      "/usr/bin/firefox-esr",
      "/usr/bin/firefox",
      "/Applications/Firefox.app/Contents/MacOS/firefox",
      "C:\\Program Files\\Mozilla Firefox\\firefox.exe",
    ],
    open: async (executablePath) => {
      // This channel is Mozilla's own build, spoken to by WebDriver BiDi.
      const browser = await firefox.launch({ executablePath, channel: "moz-firefox" });
      leaveMedia(browser);
      return { newPage: () => browser.newPage({ viewport }), close: () => browser.close() };
    },
  },
  {
    // The engine of Safari.
    name: "webkit",
    variable: "FROND_WEBKIT",
    places: ["x86_64", "aarch64"].map(
      (machine) => `/usr/lib/${machine}-linux-gnu/webkit2gtk-4.1/MiniBrowser`,
    ),
    open: openWebKit,
  },
];

/**
 * Playwright sets the colour scheme of every page by a command that Firefox does not know yet, and gives up where it
 * fails. No scenario needs another scheme than the browser's own.
 */
function leaveMedia(browser: unknown): void {
  const impl = (browser as Inner)._connection.toImpl(browser);
  const session = Object.getPrototypeOf(impl._browserSession) as Session;
  const { send } = session;
  session.send = function (this: Session, method, params) {
    if (method === "emulation.setMediaFeaturesOverride") return Promise.resolve({});
    return send.call(this, method, params);
  };
}

interface Session {
  send(method: string, params: unknown): Promise<unknown>;
}

interface Inner {
  _connection: { toImpl(it: unknown): { _browserSession: Session } };
}

export const names = rows.map(({ name }) => name);

export async function open(name: string): Promise<Opened> {
  const row = rows.find((row) => row.name === name);
  if (!row) throw new Error(`the table of browsers has no ${name}`);
  const program = process.env[row.variable] ?? row.places.find((place) => existsSync(place));
  if (program === undefined) throw new Error(`${name} is not installed; ${row.variable} says where it is`);
  return row.open(program);
}
