import { readFile } from "node:fs/promises";
import { expect } from "vitest";
import init, * as frond from "../../www/pkg/index.js";

const read = (name: string) => readFile(new URL(`../../www/pkg/${name}`, import.meta.url));

/** Loads the three modules of the package's first entry. */
export const load = () =>
  init({
    frond: read("frond_bg.wasm"),
    curve: read("frond-curve_bg.wasm"),
    proof: read("frond-proof_bg.wasm"),
  });

/** Loads the module for space. */
export const loadSpace = async () => {
  const space = await import("../../www/pkg/frond-space.js");
  await space.default({ module_or_path: read("frond-space_bg.wasm") });
  return space;
};

/** A shape of the gallery of the plane. */
export function shape(id: string): frond.Ifs {
  const found = frond.presets().find((preset) => preset.id === id);
  if (!found) throw new Error(`there is no preset ${id}`);
  return found;
}

/** What no type allows and JavaScript may pass all the same. */
export const wrong = (value: unknown) => value as never;

/** The code of the error that a call throws, whose message has to help. */
export function refused(call: () => unknown): string {
  try {
    call();
  } catch (problem) {
    const { code, message } = problem as { code: string; message: string };
    expect(message.length, "a message says what to do").toBeGreaterThan(20);
    return code;
  }
  throw new Error("it was not refused");
}
