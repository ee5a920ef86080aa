/** The address bar: what it asks for, and the document in it. */
import { effect, type ReadonlySignal, signal } from "@preact/signals";
import { arrived, placeOf, withCheck } from "#format/link-mending";
import type { FrondError, Scene } from "#wasm/api";
import { phasePlaying } from "./deform/bend";
import * as messages from "./messages";
import { notify, wordsOf } from "./notice";
import { playing, spacePlaying } from "./playback";
import { edit, inGesture, scene, start } from "./scene";

export type Route = { page: "studio" } | Place;

/** The figures or the lessons: all of them, or one. */
export interface Place {
  page: "figures" | "learn";
  figure: string | null;
  /** What the one is set to, as it writes it itself; empty as it begins. */
  state: string;
}

/** The part of the wasm package that turns documents into links and back. */
export interface Codec {
  encodeScene(scene: Scene): string;
  decodeScene(text: string): { scene: Scene; problem?: FrondError };
  defaultScene(): Scene;
}

/** The browser's address bar, or the tests' own. */
export interface Address {
  read(): string;
  write(fragment: string): void;
}

const REST_MS = 350;
const routed = signal<Route>({ page: "studio" });

/** What the address asks for. */
export const route: ReadonlySignal<Route> = routed;

/** Goes up just before a link that was followed becomes the document. */
export const openings = signal(0);

/**
 * `#figures`, `#figures/3`, `#learn` and `#learn/e1` are pages, `#learn/e1/r=0.3` one that is set to something; every
 * other fragment is a document. Lessons were among the figures once: `#figures/e1` leads to them still.
 */
export function parseRoute(fragment: string): Route {
  const page = /^(figures|learn)(?:\/([\w-]{1,32})(?:\/(\S*))?)?$/;
  const match = page.exec(fragment) ?? page.exec(placeOf(fragment));
  if (!match) return { page: "studio" };
  const [, place, figure = null, state = ""] = match;
  return { page: place === "learn" || /^e\d+$/i.test(figure ?? "") ? "learn" : "figures", figure, state };
}

/** Keeps the address and the document in step, each following the other. */
export class Link {
  readonly #codec: Codec;
  readonly #address: Address;
  #timer: ReturnType<typeof setTimeout> | null = null;
  /** The document that the address stands for. */
  #kept: Scene | null = null;
  /** The fragment that was last read or written. */
  #seen = "";

  readonly #onOpen: () => void;
  /** The browser left an entry of its history that it comes back to at once: nothing is followed meanwhile. */
  holding = false;

  constructor(codec: Codec, address: Address, onOpen: () => void = () => {}) {
    this.#codec = codec;
    this.#address = address;
    this.#onOpen = onOpen;
  }

  /** Reads the address for the first time. */
  open(): void {
    const fragment = this.#address.read();
    this.#seen = fragment;
    routed.value = parseRoute(fragment);
    const text = routed.peek().page === "studio" ? fragment : "";
    start(this.#decode(text));
    this.#kept = scene.peek();
  }

  /** The address has changed from outside: a link was followed, or the back button pressed. */
  follow(): void {
    if (this.holding) return;
    this.#stop();
    const fragment = this.#address.read();
    this.#seen = fragment;
    const next = parseRoute(fragment);
    routed.value = next;
    if (next.page !== "studio") return;
    // A document that no link can hold has the empty one, and stays.
    if (fragment === (this.fragment() ?? "")) return;
    const opened = this.#decode(fragment);
    openings.value++;
    edit(() => opened);
    this.#onOpen();
    this.#kept = scene.peek();
  }

  /** The present document, with a change, as a fragment; null when no link can hold it. */
  fragment(change: Partial<Scene> = {}): string | null {
    try {
      return withCheck(this.#codec.encodeScene({ ...scene.peek(), ...change }));
    } catch {
      return null;
    }
  }

  /** Writes every change into the address once things have come to rest. Returns the end of it. */
  watch(): () => void {
    const stop = effect(() => {
      const now = scene.value;
      // While it moves there is nothing worth keeping, and browsers count how often the address is written.
      if (playing.value || phasePlaying.value || spacePlaying.value || inGesture.value || now === this.#kept)
        return;
      this.#stop();
      this.#timer = setTimeout(() => this.flush(), REST_MS);
    });
    return () => {
      stop();
      this.#stop();
    };
  }

  /**
   * Writes now: somebody is about to leave, or wants the address. False where no link can hold the document: that is
   * said.
   */
  flush(): boolean {
    this.#stop();
    const now = scene.peek();
    if (routed.peek().page !== "studio" || now === this.#kept) return true;
    // A link was followed this moment, and the word of it is still on its way: writing would lose it.
    if (this.#address.read() !== this.#seen) return true;
    try {
      this.#address.write(withCheck(this.#codec.encodeScene(now)));
      this.#seen = this.#address.read();
      this.#kept = now;
      return true;
    } catch (problem) {
      notify({ kind: "error", text: messages.addressIsBehind(wordsOf(problem)) });
      return false;
    }
  }

  #decode(text: string): Scene {
    if (text === "") return this.#codec.defaultScene();
    const { text: link, cutAfter } = arrived(text);
    const { scene: opened, problem } = this.#codec.decodeScene(link);
    const said = [];
    if (cutAfter !== null) said.push(messages.linkCutOff(cutAfter));
    if (problem) said.push(problem.message);
    if (said.length > 0) {
      // Of a link of a later version, or of a part of one, it shows what it can.
      const words = said.join(" ");
      const text = problem ? messages.showsDefault(words) : messages.showsRest(words);
      notify({ kind: "error", text: problem?.code === "link-later" ? words : text });
    }
    return opened;
  }

  #stop(): void {
    if (this.#timer) clearTimeout(this.#timer);
    this.#timer = null;
  }
}

/** The address bar of this page. Only the fragment is ever touched. */
export const addressBar: Address = {
  read() {
    return location.hash.replace(/^#/, "");
  },
  write(fragment) {
    history.replaceState(history.state, "", `#${fragment}`);
  },
};
