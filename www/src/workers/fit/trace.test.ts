import { afterEach, describe, expect, test, vi } from "vitest";
import type { FitModule } from "#wasm/fit";
import type { Context } from "./context";
import { traceTasks } from "./trace";

const modules = vi.hoisted(() => ({
  readTextFile: (_: Uint8Array): unknown => ({ kind: "outlines", outlines: [] }),
  readDrawing: (_: Uint8Array): unknown => ({ kind: "outlines", format: "svg", outlines: [] }),
}));
vi.mock("#wasm/text", () => ({ loadTables: async () => modules, loadDrawings: async () => modules }));

type Plain = Context<never> & { readonly fit: FitModule };

const freed: number[] = [];
let made = 0;

class Tracer {
  readonly number = ++made;
  mask = (options: unknown) => ({ mask: new Uint8Array(1), options });
  outline = () => ({ points: new Float64Array(8), area: 1, length: 4, warnings: [] });
  free = () => freed.push(this.number);
}

/** As much of a worker's inside as the tasks touch. */
function worker(): Plain {
  return {
    fit: { PictureTracer: Tracer } as unknown as FitModule,
    keep: new Map(),
    progress: () => {},
    breathe: async () => {},
    transfer: () => {},
  };
}

const ascii = (text: string) => [...text].map((c) => c.charCodeAt(0));
const chunk = (name: string, bytes: number[]) => [
  0,
  0,
  0,
  bytes.length,
  ...ascii(name),
  ...bytes,
  0,
  0,
  0,
  0,
];
const big = (n: number) => [n >>> 24, (n >>> 16) & 255, (n >>> 8) & 255, n & 255];

function png(width: number, height: number): Blob {
  const header = chunk("IHDR", [...big(width), ...big(height), 8, 6, 0, 0, 0]);
  return new Blob([new Uint8Array([0x89, ...ascii("PNG\r\n\x1a\n"), ...header, ...chunk("IEND", [])])]);
}

/** Stands in for the browser's decoder. */
function decoder(width: number, height: number): void {
  const close = () => {};
  vi.stubGlobal("createImageBitmap", async () => ({ width, height, close }));
  vi.stubGlobal(
    "OffscreenCanvas",
    class {
      getContext = () => ({
        drawImage: close,
        setTransform: close,
        getImageData: (_x: number, _y: number, w: number, h: number) => ({
          data: new Uint8ClampedArray(4 * w * h),
        }),
      });
      transferToImageBitmap = () => ({ close });
    },
  );
}

afterEach(() => vi.unstubAllGlobals());

describe("opening a file", () => {
  const open = (file: Blob, name = "leaf.png", context = worker()) =>
    traceTasks.openFile(context, { file, name });

  test("70 megapixels are refused before anything is decoded", async () => {
    const decode = vi.fn();
    vi.stubGlobal("createImageBitmap", decode);
    await expect(open(png(10_000, 7000))).rejects.toMatchObject({
      code: "too-large",
      message: expect.stringMatching(/70 megapixels, and at most 64 .* smaller/),
    });
    expect(decode).not.toHaveBeenCalled();
  });

  test("so are those whose header lies", async () => {
    decoder(9000, 9000);
    await expect(open(png(100, 100))).rejects.toMatchObject({ code: "too-large" });
  });

  test("what ends too soon, and what cannot be decoded, is damaged", async () => {
    const cut = new Blob([new Uint8Array([0xff, 0xd8, 0xff, 0xc0, 0, 17, 8, 0, 9, 0, 9, 3, 0, 0, 0])]);
    await expect(open(cut, "leaf.jpg")).rejects.toMatchObject({ code: "damaged" });
    vi.stubGlobal("createImageBitmap", async () => {
      throw new Error("The source image could not be decoded.");
    });
    await expect(open(png(9, 9))).rejects.toMatchObject({
      code: "damaged",
      message: expect.stringContaining("leaf.png"),
    });
  });

  test("a text is read as one whatever it is called, and what is wrong names the file", async () => {
    const problem = Object.assign(new Error("No numbers."), { code: "no-numbers" });
    const read = vi.spyOn(modules, "readTextFile").mockImplementation(() => {
      throw problem;
    });
    await expect(open(new Blob(["milk, bread"]), "leaf.png")).rejects.toEqual({
      code: "no-numbers",
      message: "“leaf.png”: No numbers.",
    });
    // The one module says that it is a drawing, and the other reads it.
    read.mockImplementation(() => {
      throw Object.assign(new Error("A drawing."), { code: "drawing" });
    });
    const opened = await open(new Blob(["<svg></svg>"]), "leaf.png");
    expect(opened).toMatchObject({ kind: "outlines", format: "svg", name: "leaf.png" });
    read.mockRestore();
    expect(await open(new Blob(["1,2"]), "leaf.png")).not.toHaveProperty("format");
  });

  test("what is known and not read is named, with what to do, before all of it is read", async () => {
    const heic = new Blob([new Uint8Array([0, 0, 0, 24, ...ascii("ftypheic")])]);
    vi.spyOn(heic, "arrayBuffer").mockRejectedValue(new Error("read"));
    await expect(open(heic, "leaf.jpg")).rejects.toEqual({
      code: "unknown-file",
      message:
        "“leaf.jpg” is a HEIC picture. Save it as JPEG and open that: on a phone, share it as “Most compatible”.",
    });
  });

  test("large pictures are made smaller, which is said", async () => {
    decoder(6000, 4000);
    const opened = await open(png(6000, 4000));
    expect(opened).toMatchObject({
      kind: "picture",
      width: 2508,
      height: 1672,
      warnings: [{ code: "smaller" }],
    });
  });
});

test("four pictures are held, and the one not used for longest goes", async () => {
  decoder(10, 10);
  const context = worker();
  const open = async () => {
    const opened = await traceTasks.openFile(context, { file: png(10, 10), name: "a" });
    return opened.kind === "picture" ? opened.id : -1;
  };
  const first = await open();
  const second = await open();
  await open();
  const fourth = await open();
  traceTasks.outline(context, { id: first, component: 0 });
  freed.length = 0;
  await open();
  expect(freed.length).toBe(1);
  expect(() => traceTasks.outline(context, { id: second, component: 0 })).toThrow(
    expect.objectContaining({ code: "gone" }),
  );
  expect(traceTasks.outline(context, { id: first, component: 0 }).area).toBe(1);
  traceTasks.closeFile(context, { id: fourth });
  expect(freed.length).toBe(2);
  expect(traceTasks.closeFile(context, { id: fourth })).toBeNull();
});

test("a picture that is turned is another one of the turned size", async () => {
  decoder(10, 8);
  const context = worker();
  const opened = await traceTasks.openFile(context, { file: png(10, 8), name: "a" });
  if (opened.kind !== "picture") throw new Error("no picture");
  const quarter = traceTasks.turnPicture(context, { picture: opened, quarters: 1 });
  expect(quarter).toMatchObject({ width: 8, height: 10, original: { width: 8, height: 10 }, name: "a" });
  expect(quarter.id).not.toBe(opened.id);
  const half = traceTasks.turnPicture(context, { picture: quarter, quarters: 2 });
  expect(half).toMatchObject({ width: 8, height: 10 });
});

test("what is said exactly holds there, and the rest is a hint", async () => {
  decoder(10, 10);
  const context = worker();
  const opened = await traceTasks.openFile(context, { file: png(10, 10), name: "a" });
  const id = opened.kind === "picture" ? opened.id : -1;
  const plain = { points: [1, 2], radius: 3, what: "keep" } as const;
  const exact = { ...plain, exact: true };
  const masked = traceTasks.mask(context, { id, threshold: 0, petiole: "keep", strokes: [plain, exact] });
  expect(masked).toMatchObject({ options: { threshold: 0, strokes: [exact], hints: [plain] } });
});
