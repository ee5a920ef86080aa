// Asks the built package in Node, as tests/python/asked.py does: calls as JSON on standard input, answers as JSON on
// standard output. What JSON has no word for is written so that every bit comes back.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const folder = pathToFileURL(`${process.argv[2]}/`);
const entries = ["index", "fit", "exchange"];
const modules = await Promise.all(entries.map((name) => import(new URL(`node/${name}.js`, folder))));
await Promise.all(modules.map((module) => module.default()));
const functions = Object.assign({}, ...modules);

function plain(value) {
  if (typeof value === "number" && (!Number.isFinite(value) || Object.is(value, -0))) {
    return { number: Object.is(value, -0) ? "-0" : String(value) };
  }
  if (ArrayBuffer.isView(value)) {
    const bytes = Buffer.from(value.buffer, value.byteOffset, value.byteLength);
    return { array: value.constructor.name, bytes: bytes.toString("base64") };
  }
  if (Array.isArray(value)) return value.map(plain);
  if (value && typeof value === "object") {
    return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, plain(one)]));
  }
  return value === undefined ? null : value;
}

/** Numbers of typed arrays, as an argument. */
const taken = (value) => {
  if (value?.floats) return Float64Array.from(value.floats);
  return value?.bytes ? Uint8Array.from(Buffer.from(value.bytes, "base64")) : value;
};

const answers = JSON.parse(readFileSync(0, "utf8")).map(([name, ...given]) => {
  try {
    return { answer: plain(functions[name](...given.map(taken))) };
  } catch (problem) {
    if (!problem.code) throw problem;
    return { code: problem.code, message: problem.message };
  }
});
process.stdout.write(JSON.stringify(answers));
