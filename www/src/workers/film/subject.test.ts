import { expect, it } from "vitest";
import { lasting, type Subject } from "./subject";

it("goes by faster or slower, and what is said of a moment goes with it", async () => {
  const asked: number[] = [];
  const subject: Subject = {
    id: "x",
    label: "X",
    name: "x",
    seconds: 8,
    anyLength: true,
    loops: ["once"],
    loop: "once",
    ground: "#000000",
    easing: null,
    choosesSmooth: false,
    caption: (at) => `at ${at}`,
    inset: { map: () => ({ size: 0, pixels: new Uint8ClampedArray(0), way: [] }), at: (at) => [at / 8, 0] },
    drawer: () => ({
      hands: 3,
      missing: 2,
      frame: async (at) => {
        asked.push(at);
        return null;
      },
      end() {},
    }),
  };
  const slow = lasting(subject, 16);
  expect([slow.seconds, slow.caption?.(4)]).toEqual([16, "at 2"]);
  expect(slow.inset?.at(4)).toEqual([0.25, 0]);
  const drawer = slow.drawer({ width: 1, height: 1, smooth: false, ground: "#000000" });
  await drawer.frame(16, new AbortController().signal);
  expect(asked).toEqual([8]);
  expect([drawer.hands, drawer.missing]).toEqual([3, 2]);
});
