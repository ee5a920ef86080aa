import { afterEach, expect, test } from "vitest";
import { type ProofSource, proofFrom, sayProof } from "./proof";

/** The least module that there is. */
const EMPTY = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

afterEach(() => sayProof(null));

test("takes the bytes of the module in whatever they come", async () => {
  const within = new Uint8Array(16);
  within.set(EMPTY, 4);
  const sources: ProofSource[] = [
    EMPTY,
    EMPTY.slice().buffer,
    within.subarray(4, 12),
    new DataView(within.buffer, 4, 8),
    await WebAssembly.compile(EMPTY),
  ];
  for (const source of sources) {
    sayProof(source);
    expect(await proofFrom(null)).toEqual({ module: expect.any(WebAssembly.Module) });
  }
});

test("says what it takes where it is something else", () => {
  for (const source of [5, "", {}, []])
    expect(() => sayProof(source)).toThrow("frond-proof_bg.wasm, or its bytes");
});
