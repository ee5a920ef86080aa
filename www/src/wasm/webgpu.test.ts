import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

const { hasWebGpu } = vi.hoisted(() => ({ hasWebGpu: vi.fn(async () => false) }));
vi.mock("../../pkg/renderer.js", () => ({ hasWebGpu, drawsOnCard: async () => true }));

let navigation = "navigate";
const storage = new Map<string, string>();

/** What another page of the same tab finds. */
async function nextPage() {
  vi.resetModules();
  return (await import("./webgpu")).lacksWebGpu();
}

beforeEach(() => {
  storage.clear();
  hasWebGpu.mockClear();
  navigation = "navigate";
  vi.stubGlobal("performance", { getEntriesByType: () => [{ type: navigation }] });
  vi.stubGlobal("sessionStorage", {
    getItem: (key: string) => storage.get(key) ?? null,
    setItem: (key: string, value: string) => void storage.set(key, value),
  });
});
afterEach(() => void vi.unstubAllGlobals());

describe("a browser without WebGPU", () => {
  it("is asked by the first page of a tab only, until one is loaded anew", async () => {
    expect([await nextPage(), await nextPage(), await nextPage()]).toEqual([true, true, true]);
    expect(hasWebGpu).toHaveBeenCalledTimes(1);
    navigation = "reload";
    hasWebGpu.mockResolvedValueOnce(true);
    expect(await nextPage()).toBe(false);
  });
  it("is asked all the same where nothing can be kept", async () => {
    const refuse = () => {
      throw new DOMException("no", "SecurityError");
    };
    vi.stubGlobal("sessionStorage", { getItem: refuse, setItem: refuse });
    expect(await nextPage()).toBe(true);
    expect(hasWebGpu).toHaveBeenCalledTimes(1);
  });
});

describe("a browser with WebGPU", () => {
  it("is asked by each page", async () => {
    hasWebGpu.mockResolvedValue(true);
    expect([await nextPage(), await nextPage()]).toEqual([false, false]);
    expect(hasWebGpu).toHaveBeenCalledTimes(2);
    expect(storage.size).toBe(0);
    hasWebGpu.mockResolvedValue(false);
  });
});
