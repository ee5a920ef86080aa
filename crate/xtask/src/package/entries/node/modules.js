// Modules of the package, ready to be called.
import { readFile } from "node:fs/promises";

/** One that is an entry for Node. */
export async function started(loading) {
  const module = await loading;
  await module.default();
  return module;
}

/** One that is none: only the command reads tables and drawings. */
export async function inner(name) {
  const module = await import(`../${name}.js`);
  await module.default({ module_or_path: readFile(new URL(`../${name}_bg.wasm`, import.meta.url)) });
  return module;
}
