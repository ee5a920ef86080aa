import { readFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

/**
 * The bytes of a module, which lies in the folder above this one. Bundlers that take it along put its new place for
 * the address; some put one of their site there, which is no file: then the package is read where it is installed.
 */
export async function read(address, name) {
  try {
    return await readFile(fileURLToPath(address));
  } catch (problem) {
    const installed = join(dirname(fileURLToPath(import.meta.url)), "..", name);
    return readFile(installed).catch(() => {
      throw problem;
    });
  }
}
