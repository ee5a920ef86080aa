/** A morph that the element draws itself. */

import { verdictWords } from "#format/verdict";
import { type Box, boxAt, calmTrack, type Track } from "#geometry/boxes";
import { advance, SECONDS } from "#geometry/moment";
import { type Uv, uvAt } from "#geometry/path";
import type { LinkedMorph } from "../../pkg/frond-morph.js";
import { ask, draw, enter, morphOf } from "./engine";
import type { Proof } from "./proof";
import type { Drawing } from "./protocol";
import type { PictureOptions, Shown, Teller, Told } from "./shown";
import { errorOf, FrondError } from "./trouble";

export interface PictureChoices {
  /** From one end to the other, in seconds. */
  seconds: number;
  /** Back and forth for ever; else it stops at the end. */
  loop: boolean;
  palette: number[];
  /** Whether the page chose it; else a link may have colours of its own. */
  firm: boolean;
  /** Finds the module that decides and proves. */
  proof(): Promise<Proof>;
  /** Whether nothing is to move that need not. */
  calm: boolean;
}

/** How often the way is looked at for the camera. */
const LOOKS = 13;
/** Free on each side, as a part of it. */
const MARGIN = 0.06;
const MOST_SIDE = 2048;
/** A frame that takes longer is drawn with fewer pixels while things move, at most so many times fewer a side. */
const FRAME_MS = 30;
const COARSEST = 4;

/** From the straight way to the one that was found. */
const OVER_MS = 400;

type Size = { width: number; height: number };

/** A way, and what a camera sees along it. */
interface Way {
  path: Uv[];
  track: Track;
}

export class Picture implements Shown {
  t: number;
  playing = false;
  readonly #canvas: HTMLCanvasElement;
  readonly #morph: LinkedMorph;
  readonly #fragment: string;
  readonly #tell: Teller;
  readonly #leave = enter();
  #choices: PictureChoices;
  #way: Way;
  /** What was shown while the way was sought, and since when it is left. */
  #before: (Way & { since: number }) | null = null;
  #size: Size = { width: 0, height: 0 };
  #coarse = 1;
  #heading = 1;
  #last = 0;
  #frame = 0;
  #away = false;
  #drawing = false;
  #wanted = false;
  #told = false;
  #closed = false;
  #planned: Promise<void> | null = null;
  #deciding: { t: number; told: Promise<Told> } | null = null;

  static async open(
    canvas: HTMLCanvasElement,
    { fragment, t, ...choices }: PictureChoices & { fragment: string; t: number | null },
    tell: Teller,
  ): Promise<Picture> {
    return new Picture(canvas, fragment, await morphOf(fragment).catch(refused), t, choices, tell);
  }

  private constructor(
    canvas: HTMLCanvasElement,
    fragment: string,
    morph: LinkedMorph,
    t: number | null,
    choices: PictureChoices,
    tell: Teller,
  ) {
    this.#canvas = canvas;
    this.#fragment = fragment;
    this.#morph = morph;
    this.#choices = choices;
    this.#tell = tell;
    this.t = t ?? morph.t;
    const way: Uv[] = [];
    for (let i = 0; i + 2 < morph.path.length; i += 3) way.push([...morph.path.slice(i, i + 3)] as Uv);
    this.#way = this.#seen([[0, 0], ...way, [1, 1]]);
    if (this.t > 0 && this.t < 1) void this.#plan();
  }

  /** In words, for who does not see it. */
  get words(): string {
    const { a, b } = this.#morph;
    return a === b ? a : `${a} on its way to ${b}, ${Math.round(100 * this.t)}%`;
  }

  #seen(path: Uv[]): Way {
    const looks = Array.from({ length: LOOKS }, (_, i): Box | null => {
      try {
        const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = this.#morph.bounds(...placeOn(path, i / (LOOKS - 1)));
        return { x0, y0, x1, y1 };
      } catch {
        return null;
      }
    });
    return { path, track: calmTrack(looks) };
  }

  /** The way that holds together, where the link leaves it to Frond. Until it is found the straight one is shown. */
  #plan(): Promise<void> {
    this.#planned ??= this.#found();
    return this.#planned;
  }

  async #found(): Promise<void> {
    if (!this.#morph.unplanned || this.#morph.a === this.#morph.b) return;
    try {
      const proof = await this.#choices.proof();
      if (this.#closed) return;
      const [maps, to] = [this.#rows([0, 0, 0]), this.#rows([1, 1, 0])];
      const { mode, turns } = this.#morph;
      const decided = await ask({ proof, maps, to, mode, turns: [...turns] }, this.#waits);
      if (this.#closed || !("plan" in decided)) return;
      if (!this.#choices.calm) this.#before = { ...this.#way, since: performance.now() };
      this.#way = this.#seen([...decided.plan.points] as Uv[]);
      this.#goOver();
      // The moment is the same, and its maps are others.
      this.#tell.change();
    } catch (problem) {
      const { code, message } = errorOf(problem);
      if (this.#closed) return;
      // It was away when its turn came; back again it asks once more.
      if (code === "cancelled") this.#planned = null;
      else
        this.#tell.error(
          "straight",
          `The way is straight, and may fall apart: no other was found. ${message}`,
        );
    }
  }

  readonly #waits = () => !this.#closed && !this.#away;

  /** Draws until the way that was found is all that is seen. */
  #goOver(): void {
    this.draw();
    if (!this.#before || this.#closed) return;
    if (this.#over() >= 1) this.#before = null;
    else requestAnimationFrame(() => this.#goOver());
  }

  /** How far the way is left that was shown before, 0 to 1. */
  #over(): number {
    return this.#before ? Math.min(1, (performance.now() - this.#before.since) / OVER_MS) : 1;
  }

  #rows(at: [number, number, number]): number[][] {
    const all = [...this.#morph.maps(...at)];
    return Array.from({ length: all.length / 6 }, (_, i) => all.slice(6 * i, 6 * i + 6));
  }

  #colours(): number[] {
    const { palette, firm } = this.#choices;
    const own = firm ? [] : [...this.#morph.palette];
    return own.length > 0 ? own : palette;
  }

  choose(choices: Partial<PictureChoices>): void {
    this.#choices = { ...this.#choices, ...choices };
    this.draw();
  }

  /** In pixels of the screen. */
  resize(width: number, height: number): void {
    const fit = Math.min(1, MOST_SIDE / Math.max(width, height, 1));
    this.#size = { width: Math.round(width * fit), height: Math.round(height * fit) };
    this.draw();
  }

  seek(t: number): void {
    this.pause();
    this.#move(t);
  }

  #move(t: number): void {
    if (this.t === t || this.#closed) return;
    this.t = t;
    if (t > 0 && t < 1) void this.#plan();
    this.#tell.change();
    this.draw();
  }

  play(): void {
    if (this.playing || this.#closed) return;
    this.playing = true;
    if (this.t >= 1 && !this.#choices.loop) this.t = 0;
    this.#heading = this.t >= 1 ? -1 : 1;
    this.#tell.change();
    this.#tick();
  }

  #tick(): void {
    cancelAnimationFrame(this.#frame);
    this.#last = 0;
    const step = (now: number) => {
      if (!this.playing || this.#away || this.#closed) return;
      // After a pause, such as that of a tab behind, it goes on where it was.
      const dt = this.#last === 0 ? 0 : Math.min(0.2, (now - this.#last) / 1000);
      this.#last = now;
      const speed = SECONDS / this.#choices.seconds;
      const next = advance(this.t, dt, this.#heading, { speed, loop: this.#choices.loop });
      this.#heading = next.way;
      if (next.ended) this.playing = false;
      this.#move(next.t);
      if (next.ended) {
        this.#tell.change();
        this.draw();
      } else this.#frame = requestAnimationFrame(step);
    };
    this.#frame = requestAnimationFrame(step);
  }

  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    cancelAnimationFrame(this.#frame);
    this.#tell.change();
    this.draw();
  }

  rest(away: boolean): void {
    if (this.#away === away) return;
    this.#away = away;
    if (away) return;
    if (this.t > 0 && this.t < 1) void this.#plan();
    this.draw();
    if (this.playing) this.#tick();
  }

  maps(): number[][] {
    return this.#rows(placeOn(this.#way.path, this.t));
  }

  verdict(): Promise<Told> {
    const { t } = this;
    // Whoever asks again before it is known gets the same answer.
    if (this.#deciding?.t === t) return this.#deciding.told;
    const told = this.#decided(t).finally(() => {
      if (this.#deciding?.told === told) this.#deciding = null;
    });
    this.#deciding = { t, told };
    return told;
  }

  async #decided(t: number): Promise<Told> {
    const proof = await this.#choices.proof().catch((problem) => {
      throw new FrondError("no-proof", `What decides could not be fetched. ${errorOf(problem).message}`);
    });
    // The ends are the same on every way.
    if (t > 0 && t < 1) await this.#plan();
    if (this.#closed) throw new FrondError("cancelled", "It is no longer shown.");
    const maps = this.#rows(placeOn(this.#way.path, t));
    // Whoever calls it waits, wherever the element is.
    const decided = await ask({ proof, maps }, () => true);
    if (!("connectedness" in decided)) throw new FrondError("no-proof", "It was not decided.");
    const { text, aside } = verdictWords(decided.connectedness);
    const told = { verdict: decided.connectedness.verdict, words: aside ? `${text}, ${aside}` : text };
    // What is shown by now may be another moment.
    if (this.t === t) this.#tell.verdict(told);
    return told;
  }

  async picture({ width, height }: PictureOptions): Promise<Blob> {
    const across = sideOf(width ?? this.#size.width);
    const size = {
      width: across,
      height: sideOf(height ?? (across * this.#size.height) / (this.#size.width || 1)),
    };
    const pixels = await draw(this.#of(size, 1), false);
    const canvas = this.#canvas.ownerDocument.createElement("canvas");
    Object.assign(canvas, size);
    canvas.getContext("2d")?.putImageData(new ImageData(pixels, size.width, size.height), 0, 0);
    return new Promise((resolve, reject) =>
      canvas.toBlob((blob) =>
        blob ? resolve(blob) : reject(new FrondError("no-picture", "The browser made no PNG of it.")),
      ),
    );
  }

  #of({ width, height }: Size, coarse: number): Drawing {
    const size = { width: Math.ceil(width / coarse), height: Math.ceil(height / coarse) };
    const over = this.#over();
    let box = boxAt(this.#way.track, this.t);
    let at = placeOn(this.#way.path, this.t);
    if (this.#before && over < 1) {
      const from = placeOn(this.#before.path, this.t);
      at = [0, 1, 2].map((i) => between(from[i] ?? 0, at[i] ?? 0, over)) as [number, number, number];
      const old = boxAt(this.#before.track, this.t);
      box = {
        x0: between(old.x0, box.x0, over),
        y0: between(old.y0, box.y0, over),
        x1: between(old.x1, box.x1, over),
        y1: between(old.y1, box.y1, over),
      };
    }
    const across = Math.max(box.x1 - box.x0, 1e-9);
    const up = Math.max(box.y1 - box.y0, 1e-9);
    const free = 1 - 2 * MARGIN;
    const scale = Math.min((free * size.width) / across, (free * size.height) / up);
    const view = { x: (box.x0 + box.x1) / 2, y: (box.y0 + box.y1) / 2, scale: Math.max(scale, 1e-6) };
    return { fragment: this.#fragment, at, ...size, view, palette: this.#colours() };
  }

  /** Asks for the picture as it is to be now; while one is drawn, only the last that was asked for waits. */
  draw(): void {
    this.#wanted = true;
    if (!this.#drawing) void this.#drawn();
  }

  async #drawn(): Promise<void> {
    this.#drawing = true;
    try {
      while (this.#wanted && !this.#away && !this.#closed && this.#size.width > 0 && this.#size.height > 0) {
        this.#wanted = false;
        const drawing = this.#of(this.#size, this.playing ? this.#coarse : 1);
        const began = performance.now();
        const pixels = await draw(drawing, !this.#told);
        if (this.#closed) return;
        if (this.playing) this.#tune(performance.now() - began);
        const { width, height } = drawing;
        Object.assign(this.#canvas, { width, height });
        this.#canvas.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
        if (!this.#told) this.#tell.ready();
        this.#told = true;
      }
    } catch (problem) {
      const { code, message } = errorOf(problem);
      if (!this.#closed && code !== "cancelled") this.#tell.error(code, message);
    } finally {
      this.#drawing = false;
    }
  }

  #tune(took: number): void {
    if (took > FRAME_MS) this.#coarse = Math.min(COARSEST, this.#coarse + 0.5);
    else if (took < FRAME_MS / 3) this.#coarse = Math.max(1, this.#coarse - 0.25);
  }

  close(): void {
    if (this.#closed) return;
    this.#closed = true;
    this.playing = false;
    cancelAnimationFrame(this.#frame);
    this.#leave();
    this.#morph.free();
  }
}

function placeOn(path: Uv[], t: number): [number, number, number] {
  const [u, v, w = 0] = uvAt(path, t);
  return [u, v, w];
}

const between = (from: number, to: number, share: number) => from + (to - from) * share;

function sideOf(length: number): number {
  if (!(length >= 1 && length <= 8192))
    throw new FrondError("size", "A side of a picture is 1 to 8192 pixels long.");
  return Math.round(length);
}

/** What is said of a link, for whoever writes a page. */
function refused(problem: unknown): never {
  const { code, message } = errorOf(problem);
  const known = message.replace(
    /^This link is damaged: (.*?\.) .*$/s,
    "$1 Set src, a, b or path to one that is.",
  );
  throw new FrondError(code, known);
}
