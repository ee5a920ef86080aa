import { beforeEach, expect, it, vi } from "vitest";

const SCOPE = "https://example.org/frond/";

/** What the worker listens for. */
let heard: Map<string, (event: unknown) => void>;
/** What is kept, by its address; null: no storage can be opened. */
let kept: Map<string, Response> | null;
let network: (url: string) => Promise<Response>;

beforeEach(async () => {
  vi.resetModules();
  vi.useFakeTimers();
  heard = new Map();
  kept = new Map();
  const addEventListener = (type: string, listen: (event: unknown) => void) => heard.set(type, listen);
  vi.stubGlobal("self", { registration: { scope: SCOPE }, addEventListener });
  vi.stubGlobal("FROND_BUILD", "one");
  vi.stubGlobal("fetch", ({ url }: Request) => network(url));
  vi.stubGlobal("caches", {
    async open() {
      const files = kept;
      if (!files) throw new DOMException("The disk is full.", "QuotaExceededError");
      return {
        match: async (of: string | Request) => files.get(typeof of === "string" ? of : of.url)?.clone(),
        put: async (url: string, answer: Response) => files.set(url, answer),
        keys: async () => [...files.keys()].map((url) => new Request(url)),
        delete: async (url: string) => files.delete(url),
      };
    },
  });
  await import("./sw");
});

/** What a page gets, and what is left to do then. */
async function asked(path: string): Promise<{ answer: Response; rest: Promise<unknown> }> {
  const lasting: Promise<unknown>[] = [];
  let answer: Promise<Response> | undefined;
  heard.get("fetch")?.({
    request: new Request(`${SCOPE}${path}`),
    respondWith: (given: Promise<Response>) => {
      answer = given;
    },
    waitUntil: (work: Promise<unknown>) => lasting.push(work),
  });
  if (!answer) throw new Error("It is left to the browser.");
  return { answer: await answer, rest: Promise.all(lasting) };
}

it("serves pages where nothing can be kept", async () => {
  kept = null;
  network = async (url) => new Response(url);
  for (const path of ["", "assets/first-abc.js"]) {
    const { answer, rest } = await asked(path);
    expect(await answer.text()).toBe(`${SCOPE}${path}`);
    await rest;
  }
});

it("keeps no more than it may while a page goes on loading", async () => {
  network = async () => new Response(new Uint8Array(2_000_000));
  for (let k = 0; k < 12; k++) {
    const { rest } = await asked(`assets/${k}.js`);
    await vi.runAllTimersAsync();
    await rest;
  }
  const bytes = await Promise.all(
    [...(kept ?? new Map()).values()].map(async (one) => (await one.blob()).size),
  );
  expect(bytes.length).toBe(7);
  // The last that came are those that stay.
  expect(kept?.has(`${SCOPE}assets/11.js`)).toBe(true);
});
