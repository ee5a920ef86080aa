import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { dismiss, notices, notify, wordsOf } from "./notice";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => {
  for (const { id } of notices.peek()) dismiss(id);
  vi.useRealTimers();
});

const texts = () => notices.peek().map(({ text }) => text);

it("lets what is only told leave by itself, and errors stay", () => {
  notify({ kind: "info", text: "A copy is in the clipboard." });
  notify({ kind: "error", text: "The file is empty." });
  vi.advanceTimersByTime(60_000);
  expect(texts()).toEqual(["The file is empty."]);
});

it("keeps what tells of work that goes on until the work has ended", () => {
  const id = notify({ kind: "info", text: "Drawing the picture to save …", stays: true });
  vi.advanceTimersByTime(60_000);
  expect(texts()).toEqual(["Drawing the picture to save …"]);
  dismiss(id);
  expect(texts()).toEqual([]);
});

it("says what to do where a script of the page is not there any more", () => {
  for (const said of [
    "Failed to fetch dynamically imported module: https://example.org/assets/tool-abc.js",
    "error loading dynamically imported module: https://example.org/assets/tool-abc.js",
    "Importing a module script failed.",
    "Unable to preload CSS for http://example.org/assets/tool-abc.css",
    "The program could not be loaded (404 for http://example.org/assets/frond-fit_bg-abc.wasm).",
    "Failed to fetch",
    "Load failed",
    "NetworkError when attempting to fetch resource.",
    // A host that sends its page in place of what is missing.
    "WebAssembly.compile(): expected magic word 00 61 73 6d, found 3c 21 64 6f @+0",
    "wasm validation error: at offset 4: failed to match magic number",
    "WebAssembly.Module doesn't parse at byte 0: module doesn't start with '\\0asm'",
  ])
    expect(wordsOf(new TypeError(said)), said).toContain("Reload the page");
  expect(wordsOf(new Error("The file is empty."))).toBe("The file is empty.");
});
