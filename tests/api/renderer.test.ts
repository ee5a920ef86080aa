import { describe, expect, it } from "vitest";
import type { LocusCompute } from "../../www/pkg/renderer.js";
import { createLocusCompute, timeLocus } from "../../www/pkg/renderer.js";

type Answer = { milliseconds: number; left: number };

/** A graphics card that takes so long for any locus. */
function card(answer: Answer, software = false) {
  const sizes: number[] = [];
  const run = async (_from: unknown, _to: unknown, options: { width: number }) => {
    sizes.push(options.width);
    return answer;
  };
  return { sizes, compute: { software, run } as unknown as LocusCompute };
}

/** A processor that takes about 20 ms. */
const slow = () => new Promise((resolve) => setTimeout(resolve, 20));

describe("which of the two decides a locus", () => {
  it("is the one that was faster, after both have warmed up", async () => {
    const quick = card({ milliseconds: 1, left: 0 });
    expect(await timeLocus(quick.compute, slow)).toMatchObject({ faster: "gpu", gpu: 1 });
    expect(quick.sizes).toEqual([8, 128]);
    const lame = card({ milliseconds: 1e9, left: 0 });
    expect((await timeLocus(lame.compute, slow, { size: 64 })).faster).toBe("cpu");
    expect(lame.sizes).toEqual([8, 64]);
  });

  it("counts what the card leaves to the processor", async () => {
    const half = card({ milliseconds: 0, left: (128 * 128) / 2 });
    expect((await timeLocus(half.compute, slow)).faster).toBe("cpu");
  });

  it("is never a processor that stands in for a card", async () => {
    const { compute, sizes } = card({ milliseconds: 0, left: 0 }, true);
    expect((await timeLocus(compute, slow)).faster).toBe("cpu");
    expect(sizes).toEqual([]);
  });

  it("is not asked for where there is no WebGPU", async () => {
    expect(await createLocusCompute()).toBeUndefined();
  });
});
