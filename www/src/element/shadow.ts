/** What stands in the shadow of the element: the picture or a frame, words over it, and its controls. */

import { percent } from "#format/path-words";
import sheet from "#style/element.css?inline";

const PLAY = "M8 5.2v13.6a.8.8 0 0 0 1.2.7l10.6-6.8a.8.8 0 0 0 0-1.4L9.2 4.5A.8.8 0 0 0 8 5.2z";
const PAUSE = "M7 5h3.5v14H7zM13.5 5H17v14h-3.5z";

interface Acts {
  seek(t: number): void;
  toggle(): void;
}

export class Shadow {
  readonly stage: HTMLElement;
  readonly #root: ShadowRoot;
  readonly #all: HTMLElement;
  readonly #probe: HTMLElement;
  readonly #canvas: HTMLCanvasElement;
  readonly #poster: HTMLImageElement;
  readonly #message: HTMLElement;
  readonly #verdict: HTMLElement;
  readonly #controls: HTMLElement;
  readonly #play: HTMLButtonElement;
  readonly #sign: SVGPathElement;
  readonly #slider: HTMLInputElement;
  #frame: HTMLIFrameElement | null = null;
  #asked = false;

  constructor(root: ShadowRoot, acts: Acts) {
    root.innerHTML = `
      <div class="all" part="all">
        <span class="probe" hidden></span>
        <div class="stage" part="stage">
          <img part="poster" alt="" hidden>
          <canvas part="picture" role="img" hidden></canvas>
          <p class="verdict" part="verdict" role="status" hidden></p>
          <p class="message" part="message" role="alert" hidden></p>
        </div>
        <div class="controls" part="controls" hidden>
          <button type="button" part="play"><svg viewBox="0 0 24 24" aria-hidden="true"><path/></svg></button>
          <input type="range" part="slider" min="0" max="1" step="0.001" aria-label="Time">
        </div>
      </div>`;
    const find = <E extends Element>(name: string): E => {
      const found = root.querySelector<E>(name);
      if (!found) throw new Error(name);
      return found;
    };
    this.#root = root;
    this.#all = find(".all");
    this.#probe = find(".probe");
    this.stage = find(".stage");
    this.#poster = find("img");
    this.#canvas = find("canvas");
    this.#verdict = find(".verdict");
    this.#message = find(".message");
    this.#controls = find(".controls");
    this.#play = find("button");
    this.#sign = find("path");
    this.#slider = find("input");
    this.#play.addEventListener("click", () => acts.toggle());
    this.#slider.addEventListener("input", () => acts.seek(Number(this.#slider.value)));
    this.#slider.addEventListener("keydown", (event) => {
      if (event.key !== " ") return;
      event.preventDefault();
      acts.toggle();
    });
    this.moment(0, false);
  }

  /** Each document has its own sheets; a page may forbid styles that stand in elements. */
  dress(): void {
    const view = this.stage.ownerDocument.defaultView as (Window & typeof globalThis) | null;
    if (!view || this.#root.adoptedStyleSheets.length > 0) return;
    const own = new view.CSSStyleSheet();
    own.replaceSync(sheet);
    this.#root.adoptedStyleSheets = [own];
  }

  lay(controls: boolean, poster: string | null, label: string): void {
    this.#asked = controls;
    this.#controls.hidden = !controls || this.#frame !== null;
    if (poster === null) this.#poster.removeAttribute("src");
    else if (this.#poster.getAttribute("src") !== poster) this.#poster.src = poster;
    this.#poster.hidden = poster === null || !this.#canvas.hidden || this.#frame !== null;
    this.describe(label);
  }

  /** Takes on the theme that is wanted where it stands. */
  themed(): "light" | "dark" {
    const channels = (getComputedStyle(this.#probe).color.match(/[\d.]+/g) ?? []).map(Number);
    const dark = channels.slice(0, 3).reduce((sum, channel) => sum + channel, 0) > 1.5 * 255;
    this.#all.classList.toggle("dark", dark);
    return dark ? "dark" : "light";
  }

  describe(label: string): void {
    this.#canvas.setAttribute("aria-label", label);
    this.#poster.alt = label;
    if (this.#frame) this.#frame.title = label;
  }

  moment(t: number, playing: boolean): void {
    this.#slider.value = String(t);
    this.#slider.setAttribute("aria-valuetext", percent(t));
    this.#play.setAttribute("aria-label", playing ? "Pause" : "Play");
    this.#sign.setAttribute("d", playing ? PAUSE : PLAY);
    if (playing) this.verdict("");
  }

  verdict(words: string): void {
    this.#verdict.textContent = words;
    this.#verdict.hidden = words === "";
  }

  say(message: string): void {
    this.#message.textContent = message;
    this.#message.hidden = message === "";
  }

  /** The canvas, to be drawn on. */
  drawn(): HTMLCanvasElement {
    return this.#canvas;
  }

  /** A frame in place of the canvas. */
  framed(label: string): HTMLIFrameElement {
    this.#frame = this.#canvas.ownerDocument.createElement("iframe");
    this.#frame.setAttribute("part", "frame");
    this.#frame.title = label;
    this.stage.append(this.#frame);
    this.#controls.hidden = true;
    return this.#frame;
  }

  /** There is something to be seen. */
  arrived(): void {
    this.#canvas.hidden = this.#frame !== null;
    this.#poster.hidden = true;
  }

  clear(): void {
    this.#frame?.remove();
    this.#frame = null;
    this.#canvas.hidden = true;
    this.#poster.hidden = !this.#poster.hasAttribute("src");
    this.#controls.hidden = !this.#asked;
    this.verdict("");
    this.say("");
    this.moment(0, false);
  }
}
