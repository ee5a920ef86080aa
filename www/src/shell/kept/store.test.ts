import "fake-indexeddb/auto";
import { IDBFactory, IDBObjectStore } from "fake-indexeddb";
import { openDB } from "idb";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { reasonOf, VERSION } from "#document/kept/database";
import { MOST, Store } from "./store";

let store: Store;

beforeEach(() => {
  globalThis.indexedDB = new IDBFactory();
  store = new Store();
});
afterEach(async () => {
  vi.restoreAllMocks();
  await store.close();
});

const row = (n: number) => ({ id: `id-${n}`, fragment: `v=1&n=${n}`, name: `Shape ${n}`, time: 1000 + n });
const ids = async (of = store) => (await of.list()).map(({ id }) => id);

it("lists the newest first, and one that was kept again anew", async () => {
  for (const n of [1, 3, 2]) await store.put(row(n));
  expect(await ids()).toEqual(["id-3", "id-2", "id-1"]);
  await store.put({ ...row(1), fragment: "v=1&n=9", time: 5000 });
  expect(await ids()).toEqual(["id-1", "id-3", "id-2"]);
  expect((await store.list())[0]?.fragment).toBe("v=1&n=9");
});

it("keeps twenty, and what is pinned besides", async () => {
  await store.put(row(0));
  await store.pin("id-0", true);
  for (let n = 1; n <= MOST + 2; n++) await store.put(row(n));
  const kept = await ids();
  expect(kept).toHaveLength(MOST + 1);
  expect(kept[0]).toBe("id-0");
  expect(kept).not.toContain("id-1");
  expect(kept).not.toContain("id-2");
  expect(kept).toContain("id-3");
});

it("leaves a name that was given, and the pin, when the document is kept again", async () => {
  await store.put(row(1));
  await store.put({ ...row(1), name: "By itself" });
  expect((await store.list())[0]?.name).toBe("By itself");
  await store.rename("id-1", "  My fern ");
  await store.pin("id-1", true);
  await store.put({ ...row(1), name: "By itself again" });
  expect((await store.list())[0]).toMatchObject({ name: "My fern", named: true, pinned: true });
});

it("removes one, and clears all", async () => {
  for (const n of [1, 2, 3]) await store.put(row(n));
  await store.pin("id-3", true);
  await store.remove("id-2");
  expect(await ids()).toEqual(["id-3", "id-1"]);
  await store.clear();
  expect(await ids()).toEqual([]);
});

it("does not bring back by a name what another tab has removed", async () => {
  await store.put(row(1));
  const other = new Store();
  await other.remove("id-1");
  await store.rename("id-1", "Ghost");
  const raw = await openDB("frond", VERSION);
  expect(await raw.count("documents")).toBe(0);
  raw.close();
  await other.close();
});

it("holds what two tabs keep at once", async () => {
  const other = new Store();
  await Promise.all([1, 2, 3].flatMap((n) => [store.put(row(n)), other.put(row(n + 10))]));
  expect(await ids()).toEqual(await ids(other));
  expect(await ids()).toHaveLength(6);
  await other.close();
});

it("passes over rows that are none", async () => {
  await store.put(row(1));
  const raw = await openDB("frond", VERSION);
  await raw.put("documents", { id: "a" });
  await raw.put("documents", { ...row(2), time: Number.NaN });
  await raw.put("documents", { ...row(3), fragment: 7 });
  await raw.put("documents", { ...row(4), fragment: "x".repeat((1 << 20) + 1) });
  await raw.put("documents", { ...row(5), name: "n".repeat(500), pinned: "yes" });
  raw.close();
  const rows = await store.list();
  expect(rows.map(({ id }) => id)).toEqual(["id-5", "id-1"]);
  expect(rows[0]).toMatchObject({ pinned: false, named: false });
  expect(rows[0]?.name).toHaveLength(80);
  await store.put(row(6));
  expect(await ids()).toEqual(["id-6", "id-5", "id-1"]);
});

it("keeps what was there when the disk is full, and says so", async () => {
  await store.put(row(1));
  const full = vi.spyOn(IDBObjectStore.prototype, "put").mockImplementation(() => {
    throw new DOMException("full", "QuotaExceededError");
  });
  const problem = await store.put(row(2)).catch((reason: unknown) => reason);
  expect(reasonOf(problem)).toMatch(/no room left/);
  full.mockRestore();
  expect(await ids()).toEqual(["id-1"]);
  await store.put(row(2));
  expect(await ids()).toEqual(["id-2", "id-1"]);
});

it("says what is wrong where the browser keeps nothing", async () => {
  vi.spyOn(indexedDB, "open").mockImplementation(() => {
    throw new DOMException("no", "SecurityError");
  });
  expect(reasonOf(await store.list().catch((reason: unknown) => reason))).toMatch(/private window/);
  vi.restoreAllMocks();
  expect(await ids()).toEqual([]);
  vi.stubGlobal("indexedDB", undefined);
  const bare = new Store();
  expect(reasonOf(await bare.list().catch((reason: unknown) => reason))).toMatch(/private window/);
  vi.unstubAllGlobals();
});

it("lets a newer page have the store, and tells the old one", async () => {
  await store.put(row(1));
  const newer = await openDB("frond", VERSION + 1, { upgrade() {} });
  const problem = await store.put(row(2)).catch((reason: unknown) => reason);
  expect(reasonOf(problem)).toMatch(/newer version of Frond/);
  expect(await newer.count("documents")).toBe(1);
  newer.close();
  globalThis.indexedDB = new IDBFactory();
  await store.put(row(3));
  expect(await ids()).toEqual(["id-3"]);
});
