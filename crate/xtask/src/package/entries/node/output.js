// Files that are whole or not there: each is written under another name beside its place, and takes it at its end.
import { chmodSync, close, openSync, unlinkSync, writeFile } from "node:fs";
import { access, constants, realpath, rename, stat } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { promisify } from "node:util";

/** The name of the standard output. */
export const STANDARD = "-";

const writeAll = promisify(writeFile);
/** What is not whole yet. */
const unfinished = new Set();
let count = 0;

/** For the end of the program, however it comes: nothing but this is done any more. */
export function removeUnfinished() {
  for (const path of unfinished) remove(path);
}

function remove(path) {
  unfinished.delete(path);
  try {
    unlinkSync(path);
  } catch {}
}

/**
 * A place to write what will be `file`; it is there at once. `keep` puts it in its place, `drop` takes it away. A file
 * that is none, such as a pipe or /dev/null, is written as it is, and so is one in a folder where nothing may be made.
 */
export async function placeFor(file, ending = "") {
  const old = await stat(file).catch(() => null);
  const target = old ? await realpath(file) : file;
  const beside = old?.isFile() ? await mayWriteIn(dirname(target)) : old === null;
  if (!beside) return { path: file, open: () => openSync(file, "w"), async keep() {}, drop() {} };
  const path = join(dirname(target), `.frond-${process.pid}-${++count}${ending}`);
  return {
    path,
    ...kept(path, async () => {
      if (old) chmodSync(path, old.mode & 0o777);
      await rename(path, target);
    }),
  };
}

/** The same in a folder for what nobody keeps. */
export function placeApart(ending, done) {
  const path = join(tmpdir(), `frond-${process.pid}-${++count}${ending}`);
  return {
    path,
    ...kept(path, async () => {
      await done(path);
      remove(path);
    }),
  };
}

function kept(path, done) {
  unfinished.add(path);
  return {
    // At once, so that nothing makes it after it was removed.
    open: () => openSync(path, "wx"),
    async keep() {
      await done();
      unfinished.delete(path);
    },
    drop: () => remove(path),
  };
}

const mayWriteIn = (folder) =>
  access(folder, constants.W_OK).then(
    () => true,
    () => false,
  );

export async function write(file, bytes) {
  if (file === STANDARD) return print(bytes);
  const place = await placeFor(file);
  try {
    const handle = place.open();
    try {
      await writeAll(handle, bytes);
    } finally {
      await promisify(close)(handle);
    }
    await place.keep();
  } catch (problem) {
    place.drop();
    // It is known by the name that was given.
    throw problem?.path === place.path ? Object.assign(problem, { path: file }) : problem;
  }
}

/** Waits until it is taken. */
export const print = (bytes) =>
  new Promise((resolve, reject) =>
    process.stdout.write(bytes, (problem) => (problem ? reject(problem) : resolve())),
  );

export async function writable(file) {
  if (file === STANDARD) return;
  const folder = dirname(file);
  const there = await stat(folder).catch(() => null);
  if (!there?.isDirectory()) throw new Error(`There is no folder ${folder}: make it first.`);
  const old = await stat(file).catch(() => null);
  if (old?.isDirectory()) throw new Error(`${file} is a folder: name a file in it.`);
  await access(old ? file : folder, constants.W_OK);
}
