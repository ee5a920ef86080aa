import type { Repeat } from "#wasm/api";
import type { Film } from "#workers/film/film";
import type { Subject } from "#workers/film/subject";
import type { NumbersKind, Plan } from "./plan";
import type { SEEDS, SeedName } from "./seed";

/** Something that can be filmed, and what else can be had of its time line. */
export interface FilmSubject extends Subject {
  numbers?: Numbers;
  seeds?: Seeds;
}

/** The figure that a shape in the making begins with. */
export interface Seeds {
  options: typeof SEEDS;
  value: SeedName;
  /** The same from another figure. */
  begin(other: SeedName): FilmSubject | null;
}

/** What moves as numbers. */
export interface Numbers {
  kinds: readonly { value: NumbersKind; label: string; description: string }[];
  /** What such a file is for, in a sentence or two. */
  about: Readonly<Record<NumbersKind, string>>;
  /** About how large it is; null where that cannot be told. */
  bytes(plan: Plan, loop: Repeat): number | null;
  /** Larger files are not opened here again. */
  mostBytes: number;
  make(plan: Plan, times: number[], signal: AbortSignal, onDone: (frames: number) => void): Promise<Film>;
}

/** What the stage shows now. */
export interface Still {
  subject: Subject;
  /** Seconds. */
  at: number;
  /** Of the stage, in CSS pixels. */
  stage: { width: number; height: number };
  /** Whether it can be drawn in strips, and so be larger. */
  inStrips: boolean;
  /** It in the making, where it can be shown step by step: a second a step. */
  steps?: FilmSubject | null;
}

/** What a tool has to film. */
export interface Films {
  subjects: readonly FilmSubject[];
  /** What to do where there is nothing. */
  nothing?: { words: string; label: string; disabled: boolean; run: () => void };
}
