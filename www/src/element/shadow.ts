/** What stands in the shadow of the element: the picture or a frame, words over it, and its controls. */

import { percent } from "#format/path-words";
import sheet from "#style/element.css?inline";

const PLAY = "M8 5.2v13.6a.8.8 0 0 0 1.2.7l10.6-6.8a.8.8 0 0 0 0-1.4L9.2 4.5A.8.8 0 0 0 8 5.2z";
const PAUSE = "M7 5h3.5v14H7zM13.5 5H17v14h-3.5z";

const SVG = "http://www.w3.org/2000/svg";

/** What each of the controls answers. */
const BUTTON_KEYS: readonly string[] = [" ", "Enter"];
const SLIDER_KEYS: readonly string[] = [
  " ",
  "ArrowLeft",
  "ArrowRight",
  "ArrowUp",
  "ArrowDown",
  "PageUp",
  "PageDown",
  "Home",
  "End",
];

/** With these it is a key of the browser or of the page. */
const chorded = (event: KeyboardEvent) => event.ctrlKey || event.altKey || event.metaKey;

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
  readonly #sign: SVGElement;
  readonly #slider: HTMLInputElement;
  #frame: HTMLIFrameElement | null = null;
  #asked = false;

  constructor(root: ShadowRoot, acts: Acts) {
    // Made piece by piece: a page may forbid markup that is made of text.
    const page = root.ownerDocument;
    const make = <T extends keyof HTMLElementTagNameMap>(tag: T, part = "") => {
      const element = page.createElement(tag);
      if (part) element.setAttribute("part", part);
      return element;
    };
    const classed = <T extends keyof HTMLElementTagNameMap>(tag: T, name: string, part = "") =>
      Object.assign(make(tag, part), { className: name });
    this.#root = root;
    this.#all = classed("div", "all", "all");
    this.#probe = Object.assign(classed("span", "probe"), { hidden: true });
    this.stage = classed("div", "stage", "stage");
    this.#poster = Object.assign(make("img", "poster"), { alt: "", hidden: true });
    this.#canvas = Object.assign(make("canvas", "picture"), { hidden: true });
    this.#verdict = Object.assign(classed("p", "verdict", "verdict"), { hidden: true });
    this.#message = Object.assign(classed("p", "message", "message"), { hidden: true });
    this.#controls = Object.assign(classed("div", "controls", "controls"), { hidden: true });
    this.#play = Object.assign(make("button", "play"), { type: "button" });
    this.#sign = page.createElementNS(SVG, "path");
    this.#slider = make("input", "slider");
    this.#canvas.setAttribute("role", "img");
    this.#verdict.setAttribute("role", "status");
    this.#message.setAttribute("role", "alert");
    const icon = page.createElementNS(SVG, "svg");
    icon.setAttribute("viewBox", "0 0 24 24");
    icon.setAttribute("aria-hidden", "true");
    icon.append(this.#sign);
    this.#play.append(icon);
    Object.assign(this.#slider, { type: "range", min: "0", max: "1", step: "0.001" });
    this.#slider.setAttribute("aria-label", "Time");
    this.stage.append(this.#poster, this.#canvas, this.#verdict, this.#message);
    this.#controls.append(this.#play, this.#slider);
    this.#all.append(this.#probe, this.stage, this.#controls);
    root.append(this.#all);
    this.#play.addEventListener("click", () => acts.toggle());
    this.#slider.addEventListener("input", () => acts.seek(Number(this.#slider.value)));
    this.#slider.addEventListener("keydown", (event) => {
      if (event.key !== " " || chorded(event)) return;
      event.preventDefault();
      acts.toggle();
    });
    // A page with keys of its own, as slides have, does not hear those that are answered here.
    for (const type of ["keydown", "keypress", "keyup"] as const)
      this.#controls.addEventListener(type, (event) => {
        const answered = event.target === this.#slider ? SLIDER_KEYS : BUTTON_KEYS;
        if (answered.includes(event.key) && !chorded(event)) event.stopPropagation();
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

  /** In place of the picture, or `aside` of it: there is one all the same. */
  say(message: string, aside = false): void {
    this.#message.textContent = message;
    this.#message.hidden = message === "";
    this.#message.classList.toggle("aside", aside);
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
