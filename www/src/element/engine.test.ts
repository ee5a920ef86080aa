import { expect, it, vi } from "vitest";
import { ask } from "./engine";
import type { Question } from "./protocol";

const pool = vi.hoisted(() => ({ ask: vi.fn() }));
vi.mock("./pool", () => ({
  Pool: class {
    ask = pool.ask;
  },
}));
vi.mock("./unpack", () => ({ unpacked: async () => Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0).buffer }));
vi.mock("../../pkg/frond-morph.js", () => ({ default: async () => {} }));
vi.stubGlobal("FROND_MORPH", "");

const question = (name: number): Question => ({ proof: { script: "" }, maps: [[name]], to: [[name]] });

it("asks once what many ask, as long as one of them waits, and again what failed", async () => {
  let waits = [false, true];
  pool.ask.mockImplementation(async (_, wanted: () => boolean) => {
    await null;
    if (!wanted()) throw { code: "cancelled", message: "" };
    return { plan: {} };
  });
  const [first, second] = [
    ask(question(1), () => waits[0] ?? false),
    ask(question(1), () => waits[1] ?? false),
  ];
  expect(await first).toBe(await second);
  expect(await ask(question(1), () => true)).toBe(await first);
  expect(pool.ask).toHaveBeenCalledTimes(1);
  await ask(question(2), () => true);
  expect(pool.ask).toHaveBeenCalledTimes(2);

  waits = [false, false];
  const gone = ask(question(3), () => waits[0] ?? false);
  await expect(gone).rejects.toMatchObject({ name: "FrondError", code: "cancelled" });
  await ask(question(3), () => true);
  expect(pool.ask).toHaveBeenCalledTimes(4);
});
