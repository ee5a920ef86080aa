import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { LocusCompute } from "../../www/pkg/renderer.js";
import { timeLocus } from "../../www/pkg/renderer.js";

const { open, opened } = vi.hoisted(() => {
  const opened = { software: false, free: () => undefined };
  return { opened, open: vi.fn(async () => opened) };
});
vi.mock("../../www/pkg/frond-webgpu.js", () => ({
  default: async () => undefined,
  LocusCompute: { create: open },
}));

vi.mock("../../www/pkg/frond-webgl2.js", () => ({
  default: async () => undefined,
  Renderer: { create: async () => "a picture" },
  SpaceRenderer: { create: async () => "a picture of space" },
}));

/** A browser with this adapter, or none behind the interface. */
function pretend(adapter: object | null) {
  open.mockClear();
  const requestAdapter = vi.fn(async () => adapter);
  vi.stubGlobal("navigator", { gpu: { requestAdapter } });
  return requestAdapter;
}

// What the browser said is kept by the module: a new page has one of its own.
let createLocusCompute: typeof import("../../www/pkg/renderer.js").createLocusCompute;
let renderer: typeof import("../../www/pkg/renderer.js");
beforeEach(async () => {
  vi.resetModules();
  renderer = await import("../../www/pkg/renderer.js");
  ({ createLocusCompute } = renderer);
});

afterEach(() => void vi.unstubAllGlobals());

type Answer = { milliseconds: number; left: number };

/** A graphics card that takes so long for any locus. */
function card(answer: Answer, software = false) {
  const sizes: number[] = [];
  const run = async (_from: unknown, _to: unknown, options: { width: number }) => {
    sizes.push(options.width);
    return answer;
  };
  return { sizes, compute: { software, run } as unknown as LocusCompute };
}

/** A processor that takes about 20 ms. */
const slow = () => new Promise((resolve) => setTimeout(resolve, 20));

describe("which of the two decides a locus", () => {
  it("is the one that was faster, after both have warmed up", async () => {
    const quick = card({ milliseconds: 1, left: 0 });
    expect(await timeLocus(quick.compute, slow)).toMatchObject({ faster: "gpu", gpu: 1 });
    expect(quick.sizes).toEqual([8, 128]);
    const lame = card({ milliseconds: 1e9, left: 0 });
    expect((await timeLocus(lame.compute, slow, { size: 64 })).faster).toBe("cpu");
    expect(lame.sizes).toEqual([8, 64]);
  });

  it("counts what the card leaves to the processor", async () => {
    const half = card({ milliseconds: 0, left: (128 * 128) / 2 });
    expect((await timeLocus(half.compute, slow)).faster).toBe("cpu");
  });

  it("is never a processor that stands in for a card", async () => {
    const { compute, sizes } = card({ milliseconds: 0, left: 0 }, true);
    expect((await timeLocus(compute, slow)).faster).toBe("cpu");
    expect(sizes).toEqual([]);
  });

  it.each([
    { info: { vendor: "google", architecture: "swiftshader" } },
    { info: { vendor: "mesa", description: "llvmpipe (LLVM 19, 256 bits)" } },
    { info: { vendor: "nvidia", architecture: "", isFallbackAdapter: true } },
    { isFallbackAdapter: true },
  ])("is not even loaded on a processor that stands in for a card: %o", async (adapter) => {
    pretend(adapter);
    expect(await renderer.hasGraphicsCard()).toBe(false);
    expect(await createLocusCompute()).toBeUndefined();
    expect(open).not.toHaveBeenCalled();
    expect(await createLocusCompute({ software: true })).toBe(opened);
  });

  it("is opened on a card", async () => {
    pretend({ info: { vendor: "nvidia", architecture: "hopper", isFallbackAdapter: false } });
    expect(await renderer.hasGraphicsCard()).toBe(true);
    expect(await createLocusCompute()).toBe(opened);
  });

  it("is not asked for where there is no WebGPU", async () => {
    expect(await createLocusCompute()).toBeUndefined();
  });
});

describe("whether a card draws", () => {
  /** A browser whose WebGL2 is drawn by this; without a name it has none that is quick. */
  function webGl(name?: string, masked = true): ReturnType<typeof vi.fn> {
    const names: Record<number, string | undefined> = { 1: masked ? "WebKit WebGL" : name, 2: name };
    const context = {
      RENDERER: 1,
      getExtension: (which: string) =>
        which === "WEBGL_debug_renderer_info" && masked ? { UNMASKED_RENDERER_WEBGL: 2 } : null,
      getParameter: (which: number) => names[which],
    };
    const getContext = vi.fn(() => (name === undefined ? null : context));
    vi.stubGlobal(
      "OffscreenCanvas",
      class {
        getContext = getContext;
      },
    );
    return getContext;
  }

  it.each([
    ["ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)", true, false],
    ["llvmpipe (LLVM 15.0.6, 256 bits)", false, false],
    ["ANGLE (Microsoft, Microsoft Basic Render Driver Direct3D11 vs_5_0 ps_5_0)", true, false],
    ["ANGLE (Intel, Mesa Intel(R) UHD Graphics 620 (KBL GT2), OpenGL 4.6)", true, true],
    ["Apple GPU", false, true],
  ])("is told by the name of what draws WebGL2: %s", async (name, masked, card) => {
    const getContext = webGl(name, masked);
    expect(await renderer.drawsOnCard()).toBe(card);
    expect(getContext).toHaveBeenCalledWith("webgl2", { failIfMajorPerformanceCaveat: true });
    expect(await renderer.drawsOnCard({ backend: "webgpu" })).toBe(false);
  });

  it("is none where there is no WebGL2 that is quick, and one where WebGPU is a card's", async () => {
    webGl();
    expect(await renderer.drawsOnCard()).toBe(false);
    pretend({ info: { vendor: "nvidia", architecture: "hopper", isFallbackAdapter: false } });
    vi.resetModules();
    const anew = await import("../../www/pkg/renderer.js");
    expect(await anew.drawsOnCard()).toBe(true);
    expect(await anew.drawsOnCard({ backend: "webgl2" })).toBe(false);
  });
});

describe("a browser that has no adapter, and warns when it is asked", () => {
  it("is asked once, for however many pictures and loci", async () => {
    const request = pretend(null);
    const canvas = {} as OffscreenCanvas;
    const { createRenderer, createSpaceRenderer, hasWebGpu } = renderer;
    const both = await Promise.all([createRenderer(canvas), createSpaceRenderer(canvas)]);
    expect(both).toEqual(["a picture", "a picture of space"]);
    expect(await createLocusCompute()).toBeUndefined();
    expect(await createLocusCompute({ software: true })).toBeUndefined();
    expect(await createRenderer(canvas)).toBe("a picture");
    expect([await hasWebGpu(), await renderer.hasGraphicsCard()]).toEqual([false, false]);
    expect(request).toHaveBeenCalledTimes(1);
  });

  it("is not asked at all for WebGL2", async () => {
    const request = pretend(null);
    expect(await renderer.createRenderer({} as OffscreenCanvas, { backend: "webgl2" })).toBe("a picture");
    expect(request).not.toHaveBeenCalled();
  });
});
