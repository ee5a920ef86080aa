import { expect, it } from "vitest";
import { stageSize } from "#stage/view";
import { seenIn } from "./seen";

it("keeps what is fitted while all is on the stage, above the readouts, and not too small", () => {
  stageSize.value = { width: 800, height: 600 };
  const fit = { x0: 0, y0: 0, x1: 1, y1: 1 };
  expect(seenIn(fit, fit)).toBe(true);
  expect(seenIn(fit, { ...fit, x0: -0.1, x1: 1.1, y1: 1.04 })).toBe(true);
  for (const box of [
    { ...fit, y1: 1.1 },
    { ...fit, y0: -0.1 },
    { ...fit, x1: 1.5 },
    { ...fit, x1: 0.4, y1: 0.4 },
  ])
    expect(seenIn(fit, box), JSON.stringify(box)).toBe(false);
});
