/** The kinds of file that pictures and films become, and how each is written frame by frame. */
import { WHITE } from "#style/colours";
import { type ApngFrame, apngBytes } from "#workers/film/format/apng";
import { gifColours, gifWriter } from "#workers/film/format/gif";
import { frameName } from "#workers/film/format/zip";
import { inOrder } from "#workers/film/order";
import { chunksOf } from "#workers/image/png";
import { progress } from "../progress";
import type { System, VideoKind } from "../system";
import type { Frame } from "./frame";
import { frameFile, isSame } from "./frame-file";
import type { Look } from "./shown";

/** Bytes of pictures that may be under way at a time. */
const MOST_UNDER_WAY = 1 << 29;

/** A film in the making, or one picture. */
export interface Film {
  out: string;
  look: Look;
  fps: number;
  /** Which frames are wanted, counted from 0; null of one picture. */
  frames: readonly number[] | null;
  /** Frames that are there already are left as they are. */
  resume: boolean;
  frame(i: number): Frame;
  /** The link that shows what frame i shows. */
  link(i: number): string;
  system: System;
}

/** What there is to be said of what was written. */
export interface Written {
  width: number;
  height: number;
  /** A sentence more. */
  remark?: string;
}

/** Frames one after the other, several of them under way at a time. */
async function each<T>(
  { frames, look, system }: Film,
  begin: (i: number) => Promise<T>,
  take: (i: number, result: T) => Promise<void>,
): Promise<void> {
  const wanted = frames ?? [0];
  const room = Math.floor(MOST_UNDER_WAY / (4 * look.width * look.height));
  const ahead = Math.max(1, Math.min(2 * system.pool().size, room));
  const meter = progress(system);
  await inOrder(
    wanted.length,
    ahead,
    (k) => begin(wanted[k] ?? 0),
    async (k, result) => {
      await take(wanted[k] ?? 0, result);
      meter.say((k + 1) / wanted.length, `${k + 1} of ${wanted.length} frames`);
    },
  );
  meter.end();
}

const packed = ({ system, frame, link }: Film, i: number) =>
  system.pool().png({ ...frame(i), link: link(i) });

export async function png(film: Film): Promise<Written> {
  const { system, out, look, frames } = film;
  if (!frames) {
    await system.write(out, await packed(film, 0));
    return look;
  }
  const todo = film.resume ? await missing(film) : frames;
  await each(
    { ...film, frames: todo },
    (i) => packed(film, i),
    (i, file) => system.write(frameFile(out, i), file),
  );
  const there = frames.length - todo.length;
  return there === 0 ? look : { ...look, remark: `${there} were there already` };
}

/** Those of the frames that are not there yet, or are others there. */
async function missing({ frames, system, out, look, link }: Film): Promise<number[]> {
  const todo: number[] = [];
  for (const i of frames ?? []) {
    const bytes = await system.present(frameFile(out, i));
    if (!bytes || !isSame(bytes, { ...look, opaque: look.ground !== null, link: link(i) })) todo.push(i);
  }
  return todo;
}

export async function gif(film: Film): Promise<Written> {
  const { out, look, fps, frames, frame, system } = film;
  const pool = system.pool();
  const all = frames ?? [0];
  const samples = await pool.pixels(frame(all[Math.floor(all.length / 2)] ?? 0));
  const { colours } = await gifColours(samples, look.ground);
  const writer = await gifWriter({ ...look, fps }, colours);
  const key = pool.key();
  await each(
    film,
    (i) => pool.indices({ ...frame(i), colours, key }),
    async (_, index) => writer.add(index),
  );
  await system.write(out, writer.finish());
  return look;
}

export async function apng(film: Film): Promise<Written> {
  const { out, look, fps, system } = film;
  const made: ApngFrame[] = [];
  let head: Uint8Array | null = null;
  await each(
    film,
    (i) => system.pool().png({ ...film.frame(i), link: null }),
    async (_, file) => {
      const chunks = chunksOf(file);
      head ??= chunks.find(({ type }) => type === "IHDR")?.data ?? null;
      made.push({ data: chunks.filter(({ type }) => type === "IDAT").map(({ data }) => data), count: 1 });
    },
  );
  if (head) await system.write(out, apngBytes(head, made, { ...look, fps }));
  return look;
}

/** The clock of a ZIP begins here; the hour is that of whoever reads it. */
const ZIP_BEGIN = new Date(1980, 0, 1);

export async function zip(film: Film): Promise<Written> {
  const { zipSync } = await import("fflate");
  const files: Record<string, Uint8Array> = {};
  await each(
    film,
    (i) => packed(film, i),
    async (i, file) => {
      files[frameName(i + 1)] = file;
    },
  );
  // Pictures are packed already.
  await film.system.write(film.out, zipSync(files, { level: 0, mtime: ZIP_BEGIN }));
  return film.look;
}

export const video =
  (kind: VideoKind) =>
  async (film: Film): Promise<Written> => {
    const { out, look, fps, system } = film;
    const { width, height, ground } = look;
    const encoder = await system.encoder(out, { kind, width, height, fps, ground: ground ?? WHITE });
    await each(
      film,
      (i) => system.pool().pixels(film.frame(i)),
      (_, pixels) => encoder.add(pixels),
    );
    await encoder.finish();
    const even = { width: width + (width % 2), height: height + (height % 2) };
    if (even.width === width && even.height === height) return look;
    const added = [even.width > width ? "a column" : "", even.height > height ? "a row" : ""];
    return {
      ...even,
      remark: `a video has even sides, and so ${added.filter(Boolean).join(" and ")} of the background ${added.every(Boolean) ? "are" : "is"} added`,
    };
  };
