/** What only the studio shows, in a frame: its embed page, which is talked with by messages. */

import type { Shown, Teller, Told } from "./shown";
import { FrondError } from "./trouble";
import { momentOf, type Wish } from "./wish";

export interface FrameChoices {
  /** The folder of the studio, ending with a slash. */
  studio: string;
  controls: boolean;
  locus: boolean;
  panel: boolean;
  verdict: boolean;
  theme: string | null;
  autoplay: boolean;
}

/** The address of the embed page. */
export function addressOf(
  { fragment }: Pick<Wish, "fragment">,
  choices: FrameChoices,
  origin: string,
): string {
  const words = [
    ...(["locus", "panel", "verdict"] as const).filter((word) => choices[word]),
    ...(choices.controls ? [] : ["controls=none"]),
    ...(choices.theme === "light" || choices.theme === "dark" ? [`theme=${choices.theme}`] : []),
    ...(choices.autoplay ? ["play"] : []),
    // A page without an origin, such as a file, cannot be named.
    ...(origin.startsWith("http") ? [`origin=${encodeURIComponent(origin)}`] : []),
  ];
  return `${choices.studio}embed.html${words.length > 0 ? `?${words.join("&")}` : ""}#${fragment}`;
}

const unavailable = () =>
  new FrondError("frame", "The studio shows this in a frame: open its link for that.");

export class Frame implements Shown {
  t = 0;
  playing = false;
  readonly #frame: HTMLIFrameElement;
  readonly #origin: string;
  readonly #tell: Teller;
  readonly #view: Window;
  #told: Told | null = null;
  #waiting: ((told: Told) => void)[] = [];
  #ready = false;

  constructor(frame: HTMLIFrameElement, wish: Wish, choices: FrameChoices, t: number | null, tell: Teller) {
    this.#frame = frame;
    this.#tell = tell;
    this.#view = frame.ownerDocument.defaultView ?? window;
    const address = addressOf(wish, choices, this.#view.location.origin);
    this.#origin = new URL(address).origin;
    this.#view.addEventListener("message", this.#hear);
    frame.src = address;
    if (t !== null) this.#first = t;
  }
  #first: number | null = null;

  readonly #hear = ({ source, data }: MessageEvent) => {
    if (source !== this.#frame.contentWindow || typeof data !== "object" || data?.frond !== 1) return;
    switch (data.type) {
      case "ready":
        this.#say({ type: "hello" });
        if (this.#first !== null) this.#say({ type: "seek", t: this.#first });
        break;
      case "state":
        this.t = momentOf(String(data.t)) ?? 0;
        this.playing = data.playing === true;
        if (!this.#ready) this.#tell.ready();
        this.#ready = true;
        // What was known is of another moment.
        this.#told = null;
        this.#tell.change();
        break;
      case "verdict":
        this.#told = { verdict: String(data.verdict), words: String(data.words) };
        this.#tell.verdict(this.#told);
        for (const resolve of this.#waiting.splice(0)) resolve(this.#told);
        break;
      case "error":
        this.#tell.error("frame", String(data.message));
        break;
    }
  };

  #say(message: object): void {
    // A file that is opened without a server has no origin to be named.
    const to = this.#origin === "null" ? "*" : this.#origin;
    this.#frame.contentWindow?.postMessage({ frond: 1, ...message }, to);
  }

  seek(t: number): void {
    this.#first = t;
    this.#say({ type: "seek", t });
  }

  play(): void {
    this.#say({ type: "play" });
  }

  pause(): void {
    this.#say({ type: "pause" });
  }

  async verdict(): Promise<Told> {
    return this.#told ?? new Promise((resolve) => this.#waiting.push(resolve));
  }

  maps(): number[][] {
    throw unavailable();
  }

  async picture(): Promise<Blob> {
    throw unavailable();
  }

  rest(): void {
    // The browser slows frames off the screen by itself.
  }

  close(): void {
    this.#view.removeEventListener("message", this.#hear);
    this.#frame.removeAttribute("src");
  }
}
