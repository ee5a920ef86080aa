/** Keeps what a person makes, a moment after each change: never what was only looked at, nor over another document. */
import { effect, signal, untracked } from "@preact/signals";
import { reasonOf } from "#document/kept/database";
import { openings } from "#document/link";
import { inGesture, lastStep, scene } from "#document/scene";
import { endsOf } from "#document/stand-in";
import type { Scene } from "#wasm/api";
import * as messages from "./messages";
import type { Row, Store } from "./store";

/** What is needed of the page around it; tests have their own. */
export interface Around {
  encodeScene(scene: Scene): string;
  /** The address as it stands. */
  read(): string;
  /** Whether no other tab has this document, and from now on none can have it; null where nobody can tell. */
  claim(id: string): Promise<(() => void) | null>;
  /** Which document this tab was at, over a reload. */
  tab: { get(): string | null; set(id: string | null): void };
  newId(): string;
  now(): number;
  /** Something could not be kept. */
  tell(words: string): void;
}

/** A document of this tab: from the link that opened it to the next one. */
interface Open {
  id: string | null;
  release: (() => void) | null;
  /** What it began as: it is kept once it is another one. */
  first: string;
  step: object | undefined;
}

const REST_MS = 1000;

/** What was last said about keeping; null when all is well. */
export const trouble = signal<string | null>(null);
/** Goes up when something was kept. */
export const keptTimes = signal(0);

export class Keeping {
  readonly #store: Store;
  readonly #around: Around;
  #open: Open;
  #timer: ReturnType<typeof setTimeout> | null = null;
  #pending: Scene | null = null;
  #last: Promise<void> = Promise.resolve();
  #opening = false;
  #awaited: Row | null = null;
  #made = false;

  constructor(store: Store, around: Around) {
    this.#store = store;
    this.#around = around;
    this.#open = begun();
  }

  /** After a reload the tab goes on with the document that it had. */
  resume(fragment: string, reloaded: boolean): Promise<void> {
    const id = this.#around.tab.get();
    if (id === null || fragment === "") return Promise.resolve();
    const open = this.#open;
    return this.#after(async () => {
      const row = (await this.#store.list()).find((one) => one.id === id);
      if (row && (reloaded || row.fragment === fragment)) await this.#take(open, id);
      else this.#around.tab.set(null);
    });
  }

  /** The next link that is opened is this row's, which is gone on with. */
  await(row: Row): void {
    this.#awaited = row;
  }

  watch(): () => void {
    let seen = openings.peek();
    const stops = [
      effect(() => {
        if (openings.value === seen) return;
        seen = openings.value;
        untracked(() => this.#leave());
      }),
      effect(() => {
        const now = scene.value;
        const busy = inGesture.value;
        untracked(() => this.#changed(now, busy));
      }),
    ];
    return () => {
      for (const stop of stops) stop();
      this.#stop();
    };
  }

  /** Keeps at once what waits: somebody is about to leave. */
  flush(): Promise<void> {
    this.#stop();
    const now = this.#pending;
    this.#pending = null;
    const open = this.#open;
    return now ? this.#after(() => this.#write(open, now)) : this.#last;
  }

  /** A link is opened: the document so far is kept as it is, and left. */
  #leave(): void {
    const left = this.#open;
    void this.flush().then(() => left.release?.());
    this.#around.tab.set(null);
    this.#opening = true;
  }

  #changed(now: Scene, busy: boolean): void {
    if (this.#opening) {
      this.#opening = false;
      this.#open = begun();
      this.#made = false;
      const row = this.#awaited;
      this.#awaited = null;
      if (row && this.#around.read() === row.fragment) {
        const open = this.#open;
        void this.#after(() => this.#take(open, row.id));
      }
      return;
    }
    if (lastStep() === this.#open.step) {
      // Nothing was done, or all was undone before it was kept.
      this.#stop();
      this.#pending = null;
      return;
    }
    if (made(now) === this.#open.first) {
      // Back where it began: what comes next is another document, and what was made of this one stays.
      if (this.#made) {
        const left = this.#open;
        void this.flush().then(() => left.release?.());
        this.#open = { ...begun(), first: left.first };
        this.#around.tab.set(null);
        this.#made = false;
      }
      return;
    }
    this.#made = true;
    this.#stop();
    this.#pending = now;
    if (!busy) this.#timer = setTimeout(() => void this.flush(), REST_MS);
  }

  async #take(open: Open, id: string): Promise<boolean> {
    const release = await this.#around.claim(id);
    if (!release) return false;
    open.id = id;
    open.release = release;
    if (open === this.#open) this.#around.tab.set(id);
    return true;
  }

  async #write(open: Open, now: Scene): Promise<void> {
    const { encodeScene, newId, now: clock } = this.#around;
    let fragment: string;
    try {
      fragment = encodeScene(now);
    } catch {
      trouble.value = messages.thisDocumentTooLarge;
      return;
    }
    if (open.id === null) {
      // Undone to what was kept before: it is the same document.
      const same = (await this.#store.list()).find((row) => row.fragment === fragment);
      if (!same || !(await this.#take(open, same.id))) {
        const id = newId();
        if (!(await this.#take(open, id))) open.id = id;
      }
    }
    await this.#store.put({ id: open.id ?? newId(), fragment, name: nameOf(now), time: clock() });
    trouble.value = null;
    keptTimes.value++;
  }

  /** One after the other. What goes wrong is said once; the work on the page goes on. */
  #after(work: () => Promise<unknown>): Promise<void> {
    this.#last = this.#last.then(work).then(
      () => {},
      (problem: unknown) => {
        const words = reasonOf(problem);
        if (trouble.peek() !== words) this.#around.tell(words);
        trouble.value = words;
      },
    );
    return this.#last;
  }

  #stop(): void {
    if (this.#timer) clearTimeout(this.#timer);
    this.#timer = null;
  }
}

const begun = (): Open => ({ id: null, release: null, first: made(scene.peek()), step: lastStep() });

/** What a person makes of a document: not where one looks, nor which shapes of the gallery. */
function made(of: Scene): string {
  const { t, view, tool, locus, colouring, compare, a, b, path, ...rest } = of;
  const maps = [a, b].map((shape) => (shape.preset === undefined ? shape.maps : null));
  return JSON.stringify([maps, path.kind === "drawn" ? path.points : null, rest]);
}

/** Whether a document is the open one, but for where one looks. */
export const isOpen = (other: Scene): boolean => made(other) === made(scene.peek());

/** What a document is called until somebody names it. */
export function nameOf(of: Scene): string {
  if (of.tool === "space") return messages.spaceShape;
  const { a, b } = endsOf(of);
  return a.name === b.name ? a.name : messages.fromTo(a.name, b.name);
}
