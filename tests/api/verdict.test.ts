/** What the page says of one shape, beside what its map says there: with the modules as they are built. */
import { beforeAll, expect, it } from "vitest";
import * as frond from "../../www/pkg/index.js";
import { STATE } from "../../www/src/geometry/states";
import { tasks } from "../../www/src/workers/pool/tasks";
import { load, shape } from "./frond";

beforeAll(load);

const SIDE = 25;
const EPSILON = 1 / 600;

it("is a proof wherever the map has one", async () => {
  const ends: [frond.Ifs, frond.Ifs] = [shape("dragon-3"), shape("gasket")];
  const bounds = { u0: -0.5, v0: -0.5, u1: 1.5, v1: 1.5 };
  const tiles = new frond.LocusTiles(...ends, { bounds, width: SIDE, height: SIDE, epsilon: EPSILON });
  const { state } = tiles.patch(0, 0, SIDE, SIDE);
  const map = tiles.prove(0, 0, SIDE, SIDE, state);
  tiles.free();
  const context = { frond, keep: new Map(), breathe: async () => {}, progress: () => {}, transfer: () => {} };
  let proved = 0;
  let [alone, said] = [0, 0];
  for (let k = 0; k < SIDE ** 2; k++) {
    if (map[k] !== STATE.connected) continue;
    proved++;
    const [u, v] = [k % SIDE, Math.floor(k / SIDE)].map((x) => -0.5 + (2 * x) / (SIDE - 1)) as [
      number,
      number,
    ];
    const { maps } = frond.interpolate(...ends, { u, v });
    alone += Number(frond.connectedness({ maps }, { epsilon: EPSILON }).verdict === "connected");
    const found = await tasks.verdict(context as never, { kind: "verdict", maps, epsilon: EPSILON });
    said += Number(found.verdict === "connected");
  }
  expect(said).toBe(proved);
  // A search alone does not see all of it.
  expect(alone).toBeLessThan(proved);
}, 60_000);
