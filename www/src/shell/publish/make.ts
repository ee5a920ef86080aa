/** A folder for any host of static files, as a ZIP: a page, its picture, a film, and the script that draws. */

import { bitrateOf, timesOf } from "#film/plan";
import type { FilmSubject, Still } from "#film/subject";
import { makeFilm } from "#workers/film/film";
import { makePicture } from "#workers/film/picture";
import { lasting } from "#workers/film/subject";
import { type FilmFile, indexPage, type Publication, readme, studioOf, UNFOLDED } from "./folder";
import * as messages from "./messages";

export type FilmChoice = "none" | "gif" | "mp4";

/** Seconds of a film, one way, at most. */
const MOST_SECONDS = 4;
const FILMS = {
  gif: { name: "film.gif", width: 480, height: 252, fps: 12 },
  mp4: { name: "film.mp4", width: 720, height: 378, fps: 24 },
} as const;

/** What a browser is asked about, before an MP4 is offered. */
export const mp4Settings = () => settingsOf("mp4");

function settingsOf(kind: "gif" | "mp4") {
  const { width, height, fps } = FILMS[kind];
  return { width, height, fps, bitrate: bitrateOf({ width, height, fps, quality: "good" }) };
}

export interface Ordered extends Omit<Publication, "film"> {
  film: FilmChoice;
}

/** The ZIP. Rejected when called off; `tell` hears what is being made. */
export async function makeFolder(
  { film: kind, ...rest }: Ordered,
  { subject, at }: Still,
  films: readonly FilmSubject[],
  signal: AbortSignal,
  tell: (words: string) => void,
): Promise<Uint8Array<ArrayBuffer>> {
  const studio = studioOf(rest.address);
  tell(messages.loadingRenderer);
  const [script, licenses, { strToU8, zipSync }] = await Promise.all([
    fetched(`${studio}frond-view.js`, signal),
    fetched(`${studio}licenses.txt`, signal),
    import("fflate"),
  ]);
  tell(messages.renderingPreview);
  const settings = { ...UNFOLDED, ground: subject.ground, link: rest.address };
  const picture = await makePicture({ subject, at, settings, smooth: true }, signal, () => {});
  const [moving] = films;
  const film: FilmFile | null = kind === "none" || !moving ? null : FILMS[kind];
  const publication: Publication = { ...rest, film };
  const files: Record<string, Uint8Array> = {
    "index.html": strToU8(indexPage(publication)),
    "README.txt": strToU8(readme(publication)),
    "picture.png": picture.bytes,
    "frond-view.js": script,
    "licenses.txt": licenses,
  };
  if (film && moving && kind !== "none") files[film.name] = await shortFilm(moving, kind, signal, tell);
  return zipSync(files, { level: 6 });
}

/** A short loop of what moves. */
async function shortFilm(
  moving: FilmSubject,
  kind: "gif" | "mp4",
  signal: AbortSignal,
  tell: (words: string) => void,
): Promise<Uint8Array<ArrayBuffer>> {
  const subject = lasting(moving, Math.min(MOST_SECONDS, moving.seconds));
  const loop = subject.loop === "round" ? "round" : "pingpong";
  const { fps } = FILMS[kind];
  const easing = loop === "pingpong" ? (subject.easing ?? "linear") : "linear";
  const times = timesOf({ from: 0, to: subject.seconds, fps, easing }, loop);
  const settings = { ...settingsOf(kind), kind, ground: subject.ground, dither: null };
  const photograph = subject.photograph ?? false;
  const request = {
    subject,
    times,
    settings,
    samples: 4 as const,
    photograph,
    captions: false,
    inset: false,
  };
  const { bytes } = await makeFilm(request, signal, (done) =>
    tell(messages.renderingFilm(done, times.length)),
  );
  return bytes;
}

async function fetched(address: string, signal: AbortSignal): Promise<Uint8Array> {
  const name = new URL(address).pathname.split("/").at(-1) ?? address;
  const answer = await fetch(address, { signal }).catch((problem) => {
    if (signal.aborted) throw problem;
    return null;
  });
  // A server for those who work on the page answers with a page.
  if (!answer?.ok || answer.headers.get("content-type")?.startsWith("text/html"))
    throw new Error(messages.couldNotDownloadedTry(name));
  return new Uint8Array(await answer.arrayBuffer());
}
