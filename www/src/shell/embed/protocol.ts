/**
 * What an embedded Frond and the page around it say to each other, by `postMessage`. Every message is an object with
 * `frond: 1`, which is the version, and a `type`.
 */
import { themeIn } from "#document/preferences";
import * as messages from "./messages";

/** What the page around may ask. */
export type Asked =
  /** Who asks hears of every change from now on, and at once how things are. */
  | { type: "hello" }
  | { type: "play" }
  | { type: "pause" }
  /** To a moment: 0 is the beginning, 1 the end. */
  | { type: "seek"; t: number }
  /** Another document: what stands behind the # of a link. */
  | { type: "open"; fragment: string };

/** What it is told. */
export type Told =
  /** It listens from now on: to whomever holds the frame. */
  | { type: "ready" }
  | { type: "state"; t: number; playing: boolean; fragment: string }
  | { type: "verdict"; verdict: string; words: string }
  | { type: "error"; message: string };

/** Longer links than this are none of Frond's. */
const MOST_FRAGMENT = 1 << 20;

/** What a message asks; a sentence where it asks for something that there is not; null where it is not for Frond. */
export function askedBy(data: unknown): Asked | string | null {
  if (typeof data !== "object" || data === null || !("frond" in data)) return null;
  const { frond, type, t, fragment } = data as Record<string, unknown>;
  if (frond !== 1) return messages.versionOnly;
  switch (type) {
    case "hello":
    case "play":
    case "pause":
      return { type };
    case "seek":
      return typeof t === "number" && t >= 0 && t <= 1 ? { type, t } : messages.seekNeeds;
    case "open":
      return typeof fragment === "string" && fragment.length <= MOST_FRAGMENT
        ? { type, fragment: fragment.replace(/^[^#]*#/, "") }
        : messages.openNeeds;
    default:
      return messages.knownTypes;
  }
}

export interface EmbedOptions {
  /** What is shown besides the picture and the slider. */
  locus: boolean;
  verdict: boolean;
  panel: boolean;
  /** Whether there is a slider. */
  controls: boolean;
  theme: "light" | "dark" | null;
  /** The only one that is heard; null: whoever holds the frame. */
  origin: string | null;
}

/** `embed.html?verdict&theme=dark&origin=https://example.org#a=fern` */
export function optionsIn(search: string): EmbedOptions {
  const query = new URLSearchParams(search);
  return {
    locus: query.has("locus"),
    verdict: query.has("verdict"),
    panel: query.has("panel"),
    controls: query.get("controls") !== "none",
    theme: themeIn(search),
    origin: originOf(query.get("origin")),
  };
}

function originOf(text: string | null): string | null {
  if (text === null) return null;
  try {
    return new URL(text).origin;
  } catch {
    // Nobody has this one: who wrote something else meant to keep others out.
    return "null:";
  }
}
