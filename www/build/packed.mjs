/**
 * Writes what hosts send in fewer bytes beside the files of a folder, for those that look for it: `node packed.mjs
 * FOLDER` makes x.js.br and x.js.gz of x.js. Pictures are packed already.
 */
import { readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { promisify } from "node:util";
import { brotliCompress, constants, gzip } from "node:zlib";

const SENT = /\.(?:css|html|js|json|svg|txt|wasm|webmanifest|xml)$/;
/** What is smaller fits into one packet as it is. */
const LEAST = 1024;
const WAYS = [
  [".gz", (bytes) => promisify(gzip)(bytes, { level: 9 })],
  [
    ".br",
    (bytes) =>
      promisify(brotliCompress)(bytes, {
        params: { [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length, [constants.BROTLI_PARAM_QUALITY]: 11 },
      }),
  ],
];

/** Packs all of a folder. What was packed before and is no longer sent goes. */
export async function pack(folder) {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) =>
    entry.isFile(),
  );
  const paths = files.map(({ parentPath, name }) => join(parentPath, name));
  for (const path of paths) if (/\.(?:br|gz)$/.test(path)) rmSync(path);
  let [before, after] = [0, 0];
  await Promise.all(
    paths
      .filter((path) => SENT.test(path))
      .map(async (path) => {
        const bytes = readFileSync(path);
        if (bytes.length < LEAST) return;
        before += bytes.length;
        for (const [end, way] of WAYS) {
          const packed = await way(bytes);
          writeFileSync(path + end, packed);
          if (end === ".br") after += packed.length;
        }
      }),
  );
  return { before, after };
}

const [, script = "", folder] = process.argv;
if (script.endsWith("packed.mjs") && folder) {
  const { before, after } = await pack(folder);
  const mega = (bytes) => (bytes / 1e6).toFixed(1);
  process.stdout.write(
    `    ${mega(before)} MB are sent as ${mega(after)} MB by a host that takes .br files\n`,
  );
}
