/** Reads a series of a file, in the worker that reads files. */
import { fitTask } from "#workers/fit/client";
import type { OpenedSeries } from "#workers/fit/trace-types";
import * as messages from "../messages";

/** Throws what says what to try. */
export async function readSeries(file: File): Promise<OpenedSeries> {
  const got = await fitTask("openFile", { file, name: file.name, as: "series" }, { lane: 1 });
  if (got.kind === "series") return got;
  if (got.kind === "picture") got.bitmap.close();
  const what = got.kind === "picture" ? messages.picture : messages.outline2;
  throw {
    code: "no-series",
    message: messages.notSeries(file.name, what),
  };
}
