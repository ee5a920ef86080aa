/** Shapes that a way across has matched are known again when their link is opened. */
import { beforeAll, expect, it, vi } from "vitest";
import * as frond from "../../www/pkg/index.js";
import { load } from "./frond";

vi.mock("#wasm/core", async () => ({ frond: await import("../../www/pkg/index.js") }));
vi.mock("#workers/pool/engine", () => ({ epoch: { value: 0 }, submit: () => {} }));

const { isMatched } = await import("#tools/morph/shapes/recall");
const { takeRoute } = await import("#tools/morph/ways");
const { swap } = await import("#tools/morph/edits");

beforeAll(load);

type Scene = ReturnType<typeof frond.defaultScene>;

const ask: Parameters<typeof isMatched>[1] = async (task) =>
  task.kind === "ways"
    ? frond.ways(task.from, task.to, { limit: task.limit })
    : frond.routes(task.from, task.to);

const pair = (first: string, last: string): Scene => frond.decodeScene(`v=1&a=${first}&b=${last}`).scene;
const linked = (scene: Scene): Scene => frond.decodeScene(frond.encodeScene(scene)).scene;

/** What becomes of a pair on the way of a kind, in a link. */
function taken(first: string, last: string, kind: string): Scene {
  const now = pair(first, last);
  const way = frond.ways(now.a, now.b, { limit: 240 }).find((one) => one.kind === kind);
  if (!way) throw new Error(`no way of the kind ${kind} from ${first} to ${last}`);
  return linked(takeRoute(now, way));
}

it("are those of a way, in whichever order they stand", async () => {
  const joined = taken("koch", "dragon", "joints");
  expect([joined.a.preset, joined.b.preset]).not.toContain("dragon");
  expect(await isMatched(joined, ask)).toBe(true);
  expect(await isMatched(linked(swap(joined)), ask)).toBe(true);
  expect(await isMatched(taken("dragon", "gasket", "symmetry"), ask)).toBe(true);
});

it("are not those that somebody has changed, or whose names nobody knows", async () => {
  const joined = taken("koch", "dragon", "joints");
  const [first = [0, 0, 0, 0, 0, 0], ...others] = joined.b.maps;
  const [a, ...rest] = first;
  const bent = { ...joined.b, maps: [[a + 1e-12, ...rest] as typeof first, ...others] };
  expect(await isMatched(linked({ ...joined, b: bent }), ask)).toBe(false);
  expect(await isMatched({ ...joined, b: { ...joined.b, name: "Mine" } }, ask)).toBe(false);
});
