import { beforeEach, expect, test, vi } from "vitest";
import { castsShadows, Still } from "./still";
import type { Wanted } from "./surface";

/** What was carved, seen from the lamp and lit, in this order. */
const made = vi.hoisted(() => [] as string[]);
vi.mock("#workers/space/bands", () => ({
  reliefInBands: async ({ width }: { width: number }) => {
    made.push(`relief ${width}`);
    return { width };
  },
  lampInBands: async (_request: unknown, side: number) => {
    made.push(`lamp ${side}`);
    return new Float32Array(side * side);
  },
  litInBands: async (_request: unknown, { width }: { width: number }, { lamp }: { lamp: Float32Array }) => {
    made.push(`lit ${width} ${lamp.length}`);
    return { width };
  },
}));

const LIGHT = { paint: "map", side: 0, front: 0.5, ambient: 0.3, hollows: 0.5, fog: 0, shadows: 1 } as const;
const sight = {
  objects: [],
  handle: {
    lightReach: () => 64,
    lampSide: (_view: unknown, light: { shadows?: number }) => (light.shadows ? 5 : 0),
  },
} as unknown as Wanted["sight"];
const WANTED: Wanted = {
  sight,
  view: { target: [0, 0, 0], distance: 1, turn: 0, tilt: 0, angle: 1 },
  light: LIGHT,
  width: 10,
  height: 8,
  factor: 2,
  palette: [],
  ground: "#000000",
};

const signal = new AbortController().signal;
async function both(still: Still, wanted: Wanted): Promise<string[]> {
  made.length = 0;
  for (const factor of [1, 2] as const)
    await still.lit(wanted, factor, await still.relief(wanted, factor, signal), signal);
  return [...made];
}

beforeEach(() => {
  made.length = 0;
});

test("what was carved is kept while the view stays, and what the lamp sees while it stands where it stood", async () => {
  const still = new Still();
  expect(await both(still, WANTED)).toEqual(["relief 10", "lamp 5", "lit 10 25", "relief 20", "lit 20 25"]);
  const darker = { ...WANTED, light: { ...LIGHT, ambient: 0.1 }, palette: ["#ff0000"] };
  expect(await both(still, darker)).toEqual(["lit 10 25", "lit 20 25"]);
  const aside = { ...WANTED, light: { ...LIGHT, side: 1 } };
  expect(await both(still, aside)).toEqual(["lamp 5", "lit 10 25", "lit 20 25"]);
  const none = { ...WANTED, light: { ...LIGHT, shadows: 0 } };
  expect(await both(still, none)).toEqual(["lit 10 0", "lit 20 0"]);
  const turned = { ...WANTED, view: { ...WANTED.view, turn: 1 } };
  expect((await both(still, turned))[0]).toBe("relief 10");
});

test("the light of before is that of a graphics card as well", () => {
  const { shadows: _shadows, ...before } = LIGHT;
  expect(castsShadows({ light: before })).toBe(false);
  expect(castsShadows({ light: { ...before, sky: 1, gloss: 1, filmic: true } })).toBe(false);
  expect(castsShadows({ light: LIGHT })).toBe(true);
  expect(castsShadows({ light: { ...before, occlusion: 0.1 } })).toBe(true);
});
