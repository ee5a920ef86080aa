import { readFile } from "node:fs/promises";
import { beforeAll, beforeEach, describe, expect, it, vi } from "vitest";
import type { Space, SpaceTimeline } from "../../www/src/wasm/api";
import { solid, startSpace } from "../../www/src/wasm/space";

vi.mock("../../www/src/wasm/module", () => ({
  once: (get: () => Promise<unknown>) => get,
  compiled: async () =>
    WebAssembly.compile(await readFile(new URL("../../www/pkg/frond-space_bg.wasm", import.meta.url))),
}));

const { redo, scene, start, undo } = await import("../../www/src/document/scene");
const { notices } = await import("../../www/src/document/notice");
const state = await import("../../www/src/document/space/space");
const edits = await import("../../www/src/document/space/edits");
const { exportTasks } = await import("../../www/src/workers/space/export");
const { timesOf } = await import("../../www/src/film/plan");
const { takeAnimation } = await import("../../www/src/tools/space/time/saved/open");

const first = { ...scene.peek() };
const context = { progress: () => {}, breathe: async () => {}, transfer: () => {}, keep: new Map() };

/** What the export writes of the present animation. */
async function exported(fps = 10): Promise<string> {
  const [space, view, line] = [state.space.peek(), state.spaceView.peek(), state.timeline.peek()];
  if (!space || !view || !line) throw new Error("nothing moves");
  const { packed, at } = state.spacePart.peek();
  const { seconds, loop } = line;
  const times = timesOf({ from: 0, to: seconds, fps }, loop === "pingpong" ? "once" : loop);
  const request = { space, view, times, packed, at, loop, fps, seconds };
  const { bytes } = await exportTasks.parameters(context as never, request);
  return new TextDecoder().decode(bytes);
}

const open = (text: string, name = "frames.json") =>
  takeAnimation(new File([text], name, { type: "application/json" }));
const begin = (packed: string) => start({ ...first, space: { packed, at: 0 } });

beforeAll(async () => {
  const module = await WebAssembly.compile(
    await readFile(new URL("../../www/pkg/frond-space_bg.wasm", import.meta.url)),
  );
  await startSpace(module);
  await state.openSpace();
});

describe("every frame of an animation, as a file", () => {
  beforeEach(() => {
    begin("o:pyramid/o:sponge~c12ab9f/l:height,-0.56,0.55,0.35,0.75,0.25");
    edits.addKey();
    state.setMoment(2.5);
    edits.moveObject(solid.turning3([1, 2, 3], 1.2, [0.5, 0, 0]));
    edits.addKey();
    state.setMoment(6);
    edits.moveObject([1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0]);
    edits.addKey();
  });

  it("is opened with its keys, and written again as it was", async () => {
    for (const loop of ["once", "round", "pingpong"] as const) {
      edits.changeTimeline((line: SpaceTimeline) => ({ ...line, loop }));
      const before = state.spacePart.peek().packed;
      const text = await exported();
      expect(JSON.parse(text).frames).toHaveLength(60);
      begin("o:octahedron");
      await open(text);
      expect(state.spacePart.peek().packed).toBe(before);
      expect(await exported()).toBe(text);
      // One step to undo.
      undo();
      expect(state.spacePart.peek().packed).toBe("o:octahedron");
      redo();
    }
  });

  it("becomes a key for each where it was changed, or is of another program, and comes back as that", async () => {
    const file = JSON.parse(await exported(1)) as {
      frames: { objects: { name: string }[] }[];
      packed?: string;
    };
    expect(file.frames).toHaveLength(6);
    for (const foreign of [false, true]) {
      if (foreign) delete file.packed;
      else for (const frame of file.frames) Object.assign(frame.objects[0] ?? {}, { name: "Mine" });
      await open(JSON.stringify(file));
      const now = state.space.peek() as Space;
      expect(now.timeline?.keys).toHaveLength(6);
      expect(now.objects.map(({ name }) => name)).toEqual(["Mine", file.frames[0]?.objects[1]?.name]);
      const again = JSON.parse(await exported(1)) as typeof file;
      const numbers = (from: unknown): number[] =>
        typeof from === "number"
          ? [from]
          : typeof from === "object" && from
            ? Object.values(from).flatMap(numbers)
            : [];
      const [one, two] = [numbers(file.frames), numbers(again.frames)];
      expect(two).toHaveLength(one.length);
      const off = one.map((x, i) => Math.abs(x - (two[i] ?? Number.NaN)));
      expect(Math.max(...off)).toBeLessThan(1e-9);
    }
  });

  it("that cannot be opened changes nothing, and is told", async () => {
    const before = scene.peek();
    const text = await exported(1);
    const damaged = JSON.parse(text) as { frames: { objects: unknown }[] };
    (damaged.frames[3] as { objects: unknown }).objects = "none";
    const swollen = JSON.parse(text) as { frames: { objects: { maps: number[][] }[] }[] };
    for (const frame of swollen.frames) for (const row of frame.objects[0]?.maps ?? []) row[0] = 2;
    for (const [bad, words] of [
      ["{", "not a JSON file"],
      [JSON.stringify(damaged), "Frame 4"],
      [JSON.stringify(swollen), "cannot be drawn"],
      ['{"frond":"space","packed":"o:nothing","at":0}', "damaged"],
    ] as const) {
      await open(bad);
      expect(scene.peek()).toBe(before);
      expect(notices.peek().at(-1)?.text).toContain(words);
    }
  });
});
