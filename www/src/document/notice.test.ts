import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { dismiss, notices, notify } from "./notice";

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
