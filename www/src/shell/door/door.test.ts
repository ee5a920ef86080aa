import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { dismiss, notices } from "#document/notice";
import { canUndo, scene, start, undo } from "#document/scene";
import { withCheck } from "#format/link-mending";
import { openFile } from "#ui/files/door";
import { listen } from "./door";

const opened: [tool: string, file: string, text: string][] = [];

vi.mock("../tools", () => ({
  whenOpen: async (tool: string) => ({
    open: async (file: File) => {
      opened.push([tool, file.name, await file.text()]);
    },
  }),
}));
vi.mock("./morph", () => ({
  intoMorph: async ({ name }: { name: string }) => {
    opened.push(["morph", name, ""]);
  },
}));
vi.mock("#wasm/exchange", () => ({
  loadExchange: async () => ({
    importFile: () => ({ systems: [{ dimension: 2, name: "fern", maps: [], remarks: [] }], remarks: [] }),
  }),
}));
vi.mock("#wasm/core", () => ({
  frond: {
    decodeScene: (link: string) =>
      link.includes("a=koch")
        ? { scene: { ...blank, t: 0.25 } }
        : { scene: blank, problem: new Error("The shape A is not known.") },
  },
}));

const blank = { ...scene.peek() };

class Field {
  dataset: Record<string, string>;
  type = "text";
  isContentEditable = false;
  constructor(settled: boolean) {
    this.dataset = settled ? { settled: "true" } : {};
  }
  matches = () => false;
}

let onPaste: (event: unknown) => void = () => {};
let stop = () => {};

beforeEach(() => {
  vi.stubGlobal("HTMLElement", Field);
  vi.stubGlobal("HTMLInputElement", Field);
  vi.stubGlobal("document", {
    addEventListener: (_: string, listener: typeof onPaste) => {
      onPaste = listener;
    },
    removeEventListener: () => {},
  });
  opened.length = 0;
  for (const { id } of notices.peek()) dismiss(id);
  start({ ...blank });
  stop = listen();
});

afterEach(() => {
  stop();
  vi.unstubAllGlobals();
});

/** Whether the paste was taken from the browser. */
function paste(text: string, target: unknown = null): boolean {
  const preventDefault = vi.fn();
  onPaste({
    defaultPrevented: false,
    clipboardData: { files: [], getData: () => text },
    target,
    preventDefault,
  });
  return preventDefault.mock.calls.length > 0;
}

const said = () => notices.peek().map(({ text }) => text);

test("an outline that is pasted goes to Fit, and maps to Morph", async () => {
  const svg = '<svg width="4" height="3"><path d="M0 0H4V3Z"/></svg>';
  expect(paste(svg)).toBe(true);
  await expect.poll(() => opened).toEqual([["fit", "Pasted outline", svg]]);
  expect(paste("T1 0 0 0 0.16 0 0 0.01")).toBe(true);
  await expect.poll(() => opened[1]).toEqual(["morph", "fern", ""]);
  expect(said()).toEqual([]);
});

test("a link that is pasted opens as one step to undo, also as a mailer changed it", () => {
  const link = withCheck("v=1&a=koch&t=0.25").replace(/&/g, "&amp;");
  expect(paste(`See https://frond.example/#${link} and tell me.`)).toBe(true);
  expect(scene.peek().t).toBe(0.25);
  expect(said()).toEqual(["Opened the pasted link. Undo brings back your previous work."]);
  undo();
  expect(scene.peek().t).toBe(blank.t);
  expect(canUndo.peek()).toBe(false);
});

test("a link that is cut off or damaged leaves the work as it is", () => {
  paste(`#${withCheck("v=1&a=koch&t=0.25").slice(0, -4)}`);
  expect(said()).toEqual([
    "The pasted link cannot be opened: it seems to be cut off after “a=koch&t=”. Copy all of it. Your work is unchanged.",
  ]);
  paste("#v=1&a=nothing");
  expect(said()[1]).toBe(
    "The pasted link cannot be opened: The shape A is not known. Your work is unchanged.",
  );
  expect(scene.peek().t).toBe(blank.t);
  expect(canUndo.peek()).toBe(false);
});

test("of other text it is said what can be pasted", () => {
  expect(paste("milk and bread")).toBe(true);
  expect(said()).toEqual([expect.stringMatching(/^Frond cannot open the pasted text\. You can paste/)]);
  expect(paste(" ")).toBe(false);
});

test("what is pasted in a field is the field's", () => {
  for (const field of [new Field(false), new Field(true)]) {
    expect(paste("0.5 0 0 0.5 0 0", field)).toBe(false);
    expect(paste("milk and bread", field)).toBe(false);
  }
  expect([opened, said()]).toEqual([[], []]);
});

test("a file that is not read is named with what to do, and no tool is left for it", async () => {
  openFile([new File(["\0\0\0\x18ftypheic\0\0\0\0mif1heic"], "leaf.jpg")]);
  await expect
    .poll(said)
    .toEqual([
      "leaf.jpg: This is a HEIC picture. Save it as JPEG and open that: on a phone, share it as “Most compatible”. Your work is unchanged.",
    ]);
  openFile([new File(["II*\0\x08\0\0\0"], "scan.tif")]);
  await expect
    .poll(() => said()[1])
    .toBe("scan.tif: This is a TIFF picture. Save it as JPEG or PNG and open that. Your work is unchanged.");
  expect(opened).toEqual([]);
});
