/** Writes which tests failed, and by what, where `cargo xtask` looks for what to say last. */
import { mkdirSync, writeFileSync } from "node:fs";
import { dirname, relative } from "node:path";
import type { FullConfig, Reporter, Suite } from "@playwright/test/reporter";

const FILE = process.env["FROND_FAILED"];
/** Colours of the terminal. */
const COLOURS = new RegExp(`${String.fromCharCode(27)}\\[[0-9;]*m`, "g");

export default class Failed implements Reporter {
  #all: Suite | null = null;
  #root = "";

  onBegin({ rootDir }: FullConfig, all: Suite): void {
    this.#all = all;
    this.#root = rootDir;
  }

  onEnd(): void {
    if (!FILE || !this.#all) return;
    const failed = this.#all.allTests().filter((test) => test.outcome() === "unexpected");
    const lines = failed.map((test) => {
      const { file, line } = test.location;
      const said = test.results.at(-1)?.error?.message ?? "";
      const why = said.replace(COLOURS, "").split("\n").slice(0, 8).join("\n    ");
      return `${relative(this.#root, file)}:${line} ${test.title}\n    ${why}\n`;
    });
    mkdirSync(dirname(FILE), { recursive: true });
    writeFileSync(FILE, lines.join(""));
  }
}
