import "fake-indexeddb/auto";
import { IDBFactory } from "fake-indexeddb";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Link } from "#document/link";
import { edit, endGesture, redo, replace, scene, start, undo } from "#document/scene";
import type { Scene } from "#wasm/api";
import { type Around, Keeping, nameOf, trouble } from "./keeping";
import { Store } from "./store";

const blank: Scene = { ...scene.peek(), a: { ...scene.peek().a, preset: "gasket" } };
const turned = (n: number) => (now: Scene) => ({ ...now, turns: [n] });

/** A codec that holds the moment and the turns. */
const codec = {
  defaultScene: () => ({ ...blank }),
  encodeScene(what: Scene) {
    if (what.turns.length > 3) throw new Error("Too long.");
    return `t=${what.t}&turn=${what.turns[0] ?? 0}`;
  },
  decodeScene(text: string) {
    const [, t, turn] = /^t=([\d.]+)&turn=(\d+)$/.exec(text) ?? [];
    return { scene: { ...blank, t: Number(t), turns: [Number(turn)] } };
  },
};

let store: Store;
let address: string;
let link: Link;
/** What tabs hold of all documents. */
let claimed: Set<string>;
let told: string[];
let clock: number;
let tab: string | null;
let stops: (() => void)[];

function around(): Around {
  return {
    encodeScene: codec.encodeScene,
    read: () => address,
    async claim(id) {
      if (claimed.has(id)) return null;
      claimed.add(id);
      return () => void claimed.delete(id);
    },
    tab: {
      get: () => tab,
      set: (id) => {
        tab = id;
      },
    },
    newId: () => `new-${clock}`,
    now: () => ++clock,
    tell: (words) => told.push(words),
  };
}

function begin(): Keeping {
  const keeping = new Keeping(store, around());
  stops.push(keeping.watch());
  return keeping;
}

function follow(fragment: string): void {
  address = fragment;
  link.follow();
}

const kept = async () => (await store.list()).map(({ fragment }) => fragment);

beforeEach(() => {
  globalThis.indexedDB = new IDBFactory();
  store = new Store();
  [address, claimed, told, clock, tab, stops] = ["", new Set(), [], 0, null, []];
  trouble.value = null;
  link = new Link(codec, { read: () => address, write: () => {} });
  start(blank);
});
afterEach(async () => {
  vi.restoreAllMocks();
  for (const stop of stops) stop();
  await store.close();
});

it("keeps what was changed, and all later changes as the same document", async () => {
  const keeping = begin();
  edit(turned(1));
  await keeping.flush();
  edit(turned(2));
  replace({ ...scene.peek(), t: 0.5 });
  await keeping.flush();
  expect(await kept()).toEqual(["t=0.5&turn=2"]);
});

it("waits for a rest", async () => {
  vi.useFakeTimers({ toFake: ["setTimeout", "clearTimeout"] });
  const put = vi.spyOn(store, "put");
  const keeping = begin();
  edit(turned(1), { gesture: "drag" });
  vi.advanceTimersByTime(5000);
  endGesture();
  vi.advanceTimersByTime(900);
  edit(turned(2));
  vi.advanceTimersByTime(900);
  vi.useRealTimers();
  expect(put).not.toHaveBeenCalled();
  await keeping.flush();
  expect(put).toHaveBeenCalledTimes(1);
});

it("keeps nothing that was only looked at", async () => {
  const keeping = begin();
  replace({ ...scene.peek(), t: 0.25 });
  replace({ ...scene.peek(), path: { kind: "auto", points: [[0, 1]] } });
  edit((now) => ({ ...now, a: { preset: "fern", name: "Fern", maps: [[0.3, 0, 0, 0.3, 0, 0]] } }));
  edit((now) => ({ ...now, colouring: "address" }));
  await keeping.flush();
  start({ ...blank });
  const computed = begin();
  replace({ ...scene.peek(), turns: [5] });
  await computed.flush();
  await keeping.flush();
  expect(await kept()).toEqual([]);
});

it("leaves what was made when all of it is taken back, and begins another with the next change", async () => {
  const keeping = begin();
  edit(turned(1));
  await keeping.flush();
  edit(() => ({ ...blank }));
  await keeping.flush();
  expect(await kept()).toEqual(["t=0&turn=1"]);
  edit(turned(7));
  await keeping.flush();
  expect(await kept()).toEqual(["t=0&turn=7", "t=0&turn=1"]);
});

it("keeps nothing of what was undone at once", async () => {
  const keeping = begin();
  edit(turned(1));
  undo();
  await keeping.flush();
  expect(await kept()).toEqual([]);
  redo();
  await keeping.flush();
  expect(await kept()).toEqual(["t=0&turn=1"]);
});

it("knows the document again when a link that was opened is undone", async () => {
  const keeping = begin();
  edit(turned(1));
  await keeping.flush();
  follow("t=0&turn=9");
  undo();
  await keeping.flush();
  edit(turned(2));
  await keeping.flush();
  expect(await kept()).toEqual(["t=0&turn=2"]);
});

it("does not write a link that is opened over what was being made, nor lose its last change", async () => {
  const keeping = begin();
  edit(turned(1));
  await keeping.flush();
  edit(turned(2));
  follow("t=0&turn=9");
  await keeping.flush();
  expect(await kept()).toEqual(["t=0&turn=2"]);
  edit(turned(10));
  await keeping.flush();
  expect(await kept()).toEqual(["t=0&turn=10", "t=0&turn=2"]);
});

it("goes on with a document of the list", async () => {
  const keeping = begin();
  edit(turned(1));
  await keeping.flush();
  follow("t=0&turn=9");
  await keeping.flush();
  const [row] = await store.list();
  if (!row) throw new Error("Nothing was kept.");
  keeping.await(row);
  follow(row.fragment);
  edit(turned(3));
  await keeping.flush();
  expect(await kept()).toEqual(["t=0&turn=3"]);
});

it("goes on after a reload, but not with another link in the same tab", async () => {
  await store.put({ id: "mine", fragment: "t=0&turn=1", name: "Mine", time: 0 });
  tab = "mine";
  start({ ...blank, turns: [1] });
  const keeping = begin();
  await keeping.resume("t=0&turn=1", false);
  edit(turned(2));
  await keeping.flush();
  expect(await kept()).toEqual(["t=0&turn=2"]);

  claimed.clear();
  start({ ...blank, turns: [4] });
  const later = begin();
  await later.resume("t=0&turn=4", false);
  edit(turned(5));
  await later.flush();
  expect(await kept()).toContain("t=0&turn=2");
});

it("keeps a document of its own where another tab has the same", async () => {
  await store.put({ id: "mine", fragment: "t=0&turn=1", name: "Mine", time: 0 });
  claimed.add("mine");
  tab = "mine";
  start({ ...blank, turns: [1] });
  const keeping = begin();
  await keeping.resume("t=0&turn=1", true);
  edit(turned(2));
  await keeping.flush();
  expect(await kept()).toEqual(["t=0&turn=2", "t=0&turn=1"]);
});

it("says once what goes wrong, and goes on when there is room again", async () => {
  const keeping = begin();
  const full = vi.spyOn(store, "put").mockRejectedValue(new DOMException("full", "QuotaExceededError"));
  for (const n of [1, 2]) {
    edit(turned(n));
    await keeping.flush();
  }
  expect(told).toHaveLength(1);
  expect(trouble.value).toMatch(/no room/);
  full.mockRestore();
  edit(turned(3));
  await keeping.flush();
  expect(trouble.value).toBeNull();
  expect(await kept()).toEqual(["t=0&turn=3"]);
});

it("leaves what was kept where no link can hold what it has become", async () => {
  const keeping = begin();
  edit(turned(1));
  await keeping.flush();
  edit((now) => ({ ...now, turns: [1, 2, 3, 4] }));
  await keeping.flush();
  expect(trouble.value).toMatch(/too large/);
  expect(await kept()).toEqual(["t=0&turn=1"]);
});

it("names a document by what is in it", () => {
  expect(nameOf(blank)).toBe("Gasket to Mirrored gasket");
  expect(nameOf({ ...blank, b: blank.a })).toBe("Gasket");
  const state = { from: 0, map: [0.5, 0, 0, 0.5, 0, 0] as [number, number, number, number, number, number] };
  const end = (name: string) => ({ name, states: [[state]] });
  expect(nameOf({ ...blank, directed: { a: end("Sun"), b: end("Quilt") } })).toBe("Sun to Quilt");
});
