import "fake-indexeddb/auto";
import { IDBFactory } from "fake-indexeddb";
import { openDB } from "idb";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Database, reasonOf, VERSION } from "./database";
import { Fits, type KeptFit, MOST_FITS, MOST_PINNED_FITS, MOST_POINTS, thinned } from "./fits";

let database: Database;
let fits: Fits;

beforeEach(() => {
  globalThis.indexedDB = new IDBFactory();
  database = new Database();
  fits = new Fits(database);
});
afterEach(async () => {
  vi.restoreAllMocks();
  await database.close();
});

const row = (n: number) => ({
  id: `id-${n}`,
  fragment: `v=1&fit=${n}`,
  name: `Leaf ${n}`,
  time: 1000 + n,
  rms: 0.07,
  bytes: 402,
  outline: Float32Array.of(0, 0, 1, 0, 0, 1),
  photograph: null,
});
const photograph = { blob: new Blob(["leaf"]), box: [-1, -1, 1, 0.5] as const };
const ids = async () => (await fits.list()).map(({ id }) => id);

it("gives back what was kept, with its outline and its photograph", async () => {
  await fits.put({ ...row(1), photograph });
  const [read] = await fits.list();
  expect(read).toMatchObject({ ...row(1), named: false, pinned: false, photograph: { box: photograph.box } });
  expect(await read?.photograph?.blob.text()).toBe("leaf");
});

it("reads a fit that was kept before photographs were", async () => {
  const { photograph: _, ...before } = row(1);
  await fits.put(before as KeptFit);
  expect((await fits.list())[0]?.photograph).toBeNull();
});

it("keeps the last forty, and what is pinned besides", async () => {
  await fits.put(row(0));
  await fits.pin("id-0", true);
  for (let n = 1; n <= MOST_FITS + 2; n++) await fits.put(row(n));
  const kept = await ids();
  expect(kept).toHaveLength(MOST_FITS + 1);
  expect(kept[0]).toBe("id-0");
  expect(kept).not.toContain("id-2");
  expect(kept).toContain("id-3");
});

it("pins no more than it can hold, and says so", async () => {
  for (let n = 0; n <= MOST_PINNED_FITS; n++) {
    await fits.put(row(n));
    if (n < MOST_PINNED_FITS) await fits.pin(`id-${n}`, true);
  }
  const problem = await fits.pin(`id-${MOST_PINNED_FITS}`, true).catch((reason: unknown) => reason);
  expect(reasonOf(problem)).toMatch(/^You can pin up to 60 items.*Unpin or remove one/);
  expect((await fits.list()).filter(({ pinned }) => pinned)).toHaveLength(MOST_PINNED_FITS);
  // What is pinned can be pinned again.
  await fits.pin("id-0", true);
});

it("puts back what was removed, as it was", async () => {
  for (const n of [1, 2]) await fits.put(row(n));
  await fits.rename("id-1", "My maple");
  await fits.pin("id-1", true);
  const before = await fits.list();
  await fits.remove("id-1");
  expect(await ids()).toEqual(["id-2"]);
  await fits.restore(before[0] as KeptFit);
  expect(await fits.list()).toEqual(before);
});

it("passes over rows that are none, and over outlines and photographs that are none", async () => {
  await fits.put(row(1));
  const raw = await openDB("frond", VERSION);
  for (const [n, change] of [
    { fragment: "" },
    { rms: Number.NaN },
    { bytes: -1 },
    { bytes: "402" },
    { outline: [0, 0, 1, 0, 0, 1] },
    { outline: Float32Array.of(0, 0, 1, Number.NaN, 0, 1) },
    { outline: new Float32Array(5) },
    { outline: new Float32Array(2 * MOST_POINTS + 2) },
    { photograph: { ...photograph, box: [1, 0, 0, 1] } },
    { photograph: { ...photograph, box: [0, 0, 1, Number.NaN] } },
    { photograph: { ...photograph, blob: "leaf" } },
    { photograph: { ...photograph, blob: new Blob([]) } },
  ].entries()) {
    await raw.put("fits", { ...row(n + 10), ...change });
  }
  raw.close();
  const read = await fits.list();
  const places = [21, 20, 19, 18, 17, 16, 15, 14, 1];
  expect(read.map(({ id }) => id)).toEqual(places.map((n) => `id-${n}`));
  expect(read.map(({ outline }) => outline?.length ?? null)).toEqual([6, 6, 6, 6, null, null, null, null, 6]);
  expect(read.every(({ photograph }) => photograph === null)).toBe(true);
});

it("comes to a database of documents, which stay", async () => {
  const old = await openDB("frond", 1, {
    upgrade: (made) => void made.createObjectStore("documents", { keyPath: "id" }),
  });
  await old.put("documents", { id: "a" });
  old.close();
  await fits.put(row(1));
  expect(await ids()).toEqual(["id-1"]);
  expect(await database.all("documents")).toEqual([{ id: "a" }]);
});

it("rejects, with words, where the browser keeps nothing", async () => {
  vi.stubGlobal("indexedDB", undefined);
  expect(reasonOf(await fits.put(row(1)).catch((reason: unknown) => reason))).toMatch(/private window/);
  vi.unstubAllGlobals();
});

it("thins an outline evenly, and only where it is too long", () => {
  const points = Float64Array.from({ length: 6 * MOST_POINTS }, (_, i) => Math.floor(i / 2));
  const thin = thinned(points);
  expect(thin).toHaveLength(2 * MOST_POINTS);
  expect([...thin.slice(0, 6)]).toEqual([0, 0, 3, 3, 6, 6]);
  expect([...thinned(Float64Array.of(1, 2, 3, 4, 5, 6))]).toEqual([1, 2, 3, 4, 5, 6]);
});
