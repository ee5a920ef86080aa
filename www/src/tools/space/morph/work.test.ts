import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { canUndo, scene, start, undo } from "#document/scene";
import type { MapRow3, PathPoint, Space } from "#wasm/api";

const half = (x: number): MapRow3 => [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, x, 0, 0];
const { asked, solid } = vi.hoisted(() => {
  interface Asked {
    name: string;
    args: Record<string, unknown>;
    answer: (result: unknown) => void;
    progress: (value: unknown) => void;
    signal: AbortSignal | undefined;
  }
  const asked: Asked[] = [];
  const space = (packed: string) => JSON.parse(packed);
  const solid = {
    packSpace: (value: unknown) => JSON.stringify(value),
    unpackSpace: space,
    defaultSpace: () => ({ objects: [], light: {} }),
    correspondence3: (from: unknown[]) => from.map((_, i) => i),
    SpaceMotion: class {
      readonly space: { objects: { maps: unknown }[]; morph?: { t: number } };
      constructor(space: { objects: { maps: unknown }[]; morph?: { t: number } }) {
        this.space = space;
      }
      at() {
        const { objects, morph } = this.space;
        return { objects: objects.map(({ maps }) => ({ maps, moved: [], now: maps })), t: morph?.t };
      }
      free() {}
    },
  };
  return { asked, solid };
});
vi.mock("#wasm/space", () => ({ solid, loadSpace: async () => {} }));
vi.mock("#workers/space/client", () => ({
  spaceTask: (
    name: string,
    args: Record<string, unknown>,
    { signal, onProgress }: { signal?: AbortSignal; onProgress?: (value: unknown) => void } = {},
  ) =>
    new Promise((resolve, reject) => {
      signal?.addEventListener("abort", () => reject({ code: "stopped", message: "" }));
      asked.push({ name, args, answer: resolve, progress: (value) => onProgress?.(value), signal });
    }),
}));

const { openSpace, editSpace, space } = await import("#document/space/space");
const { withMode, withPath } = await import("./morph-edits");
const { callOff, check, found, judged, locus, lookAgain, search, watchMorph } = await import("./work");

const first: Space = {
  objects: [{ name: "A", maps: [half(0), half(1)] }],
  light: { paint: "map", side: 0, front: 0, ambient: 0, hollows: 0, fog: 0 },
  morph: { to: { name: "B", maps: [half(0), half(2)] }, path: { kind: "auto", points: [] }, t: 0 },
};
const plan = (...points: PathPoint[]) => ({
  plan: { points: [[0, 0], ...points, [1, 1]], gap: 0, holds: true, clearance: 0.1 },
  check: { gap: 0, holds: true, breaks: [] },
});
const rest = () => new Promise((resolve) => setTimeout(resolve));
const last = (name: string) => asked.findLast((one) => one.name === name);
const count = (name: string) => asked.filter((one) => one.name === name).length;

let stop = () => {};
beforeEach(async () => {
  asked.length = 0;
  await openSpace();
  start({ ...scene.peek(), space: { packed: JSON.stringify(first), at: 0 } });
  found.value = null;
  stop = watchMorph();
  await rest();
});
afterEach(() => stop());

describe("what is worked out of a morph", () => {
  it("is asked for at once", () => {
    expect(asked.map(({ name }) => name).sort()).toEqual(["holds", "morphCheck", "morphLocus", "morphPath"]);
  });

  it("shows a path as it is found, as no undo step of its own", async () => {
    last("morphPath")?.progress({ ...plan([0.25, 0.75]), share: 0.5 });
    expect(space.value?.morph?.path).toEqual({ kind: "auto", points: [[0.25, 0.75]] });
    expect(search.value).toEqual({ share: 0.5 });
    last("morphPath")?.answer({ ...plan([0.123456, 0.9]), share: 1 });
    await rest();
    expect(space.value?.morph?.path.points).toEqual([[0.1235, 0.9]]);
    expect(search.value).toBeNull();
    expect(canUndo.value).toBe(false);
  });

  it("looks anew where the morph is another, and at what comes of that alone", async () => {
    const before = last("morphPath");
    editSpace((now) => withMode(now, "linear"));
    await rest();
    expect(before?.signal?.aborted).toBe(true);
    expect(count("morphPath")).toBe(2);
    before?.progress({ ...plan([0.9, 0.1]), share: 0.5 });
    expect(space.value?.morph?.path.points).toEqual([]);
  });

  it("asks nothing again while only the moment changes, but for what is seen", async () => {
    const [paths, fields] = [count("morphPath"), count("morphLocus")];
    editSpace((now) => ({ ...now, morph: { ...now.morph, t: 0.5 } as never }));
    await rest();
    expect([count("morphPath"), count("morphLocus")]).toEqual([paths, fields]);
  });

  it("is there again where undo goes back to before it was found", async () => {
    editSpace((now) => ({ ...now, morph: { ...now.morph, t: 0.5 } as never }));
    last("morphPath")?.answer({ ...plan([0.25, 0.75]), share: 1 });
    await rest();
    undo();
    expect(space.value?.morph).toMatchObject({ t: 0, path: { kind: "auto", points: [[0.25, 0.75]] } });
  });

  it("leaves a path alone that was drawn meanwhile", async () => {
    const search = last("morphPath");
    editSpace((now) => withPath(now, { kind: "drawn", points: [[0.5, 0.1]] }));
    search?.answer({ ...plan([0.3, 0.3]), share: 1 });
    await rest();
    expect(space.value?.morph?.path).toEqual({ kind: "drawn", points: [[0.5, 0.1]] });
  });

  it("can be called off and begun again", async () => {
    callOff();
    await rest();
    expect(search.value).toBeNull();
    expect(last("morphPath")?.signal?.aborted).toBe(true);
    lookAgain();
    expect(count("morphPath")).toBe(2);
  });

  it("tells where a path breaks of that path only", async () => {
    const straight = last("morphCheck");
    straight?.answer({ gap: 0, holds: true, breaks: [], told: [], ways: [] });
    await rest();
    // What is straight while a path is looked for is nobody's choice.
    expect(check.value).toBeNull();
    last("morphPath")?.answer({ ...plan([0.25, 0.75]), share: 1 });
    await rest();
    expect(last("morphCheck")?.args["points"]).toContainEqual([0.25, 0.75]);
    last("morphCheck")?.answer({ gap: 0.1, holds: false, breaks: [[0.2, 0.3]], told: [], ways: [] });
    await rest();
    expect(check.value?.breaks).toEqual([[0.2, 0.3]]);
    editSpace((now) => withPath(now, { kind: "drawn", points: [[0.5, 0.1]] }));
    expect(check.value).toBeNull();
  });

  it("keeps the map that there is until there is something of the next", async () => {
    last("morphLocus")?.progress({ state: new Uint8Array([1]), progress: 0.1 });
    editSpace((now) => withMode(now, "linear"));
    expect(locus.value?.progress).toBe(0.1);
    editSpace(({ morph: _, ...now }) => now);
    expect(locus.value).toBeNull();
  });

  it("says when its answer is about what was seen before", async () => {
    last("holds")?.answer({ verdict: "touching" });
    await rest();
    expect(judged.value).toMatchObject({ stale: false, answer: { verdict: "touching" } });
    editSpace((now) => ({ ...now, objects: [{ name: "A", maps: [half(0), half(3)] }] }));
    expect(judged.value?.stale).toBe(true);
  });
});
