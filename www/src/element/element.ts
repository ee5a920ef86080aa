/**
 * `<frond-view>`: a morph, or whatever else the studio shows, on any page. It loads nothing until it is near the
 * screen, and what goes wrong is an `error` event and a word in its place.
 */

import { palette } from "#style/palette";
import { Frame } from "./frame";
import { JUDGED, lightTroubles } from "./light";
import { Picture, type PictureChoices } from "./picture";
import { type ProofSource, proofFrom, saidSource, sayProof } from "./proof";
import { Properties } from "./properties";
import { Shadow } from "./shadow";
import type { PictureOptions, Shown, Teller, Told } from "./shown";
import { errorOf, FrondError } from "./trouble";
import { isOn, meansOn, textOf } from "./values";
import { momentOf, WISHES, WishError, wishOf } from "./wish";

/** So far from the screen it begins to load. */
const NEAR = "300px";
/** It rests so long before anybody is told in words where it is. */
const REST_MS = 500;
/** Where this script came from: the studio's files are beside it. Null inside of a bundle. */
const beside = originOfScript();

function originOfScript(): string | null {
  if (typeof document === "undefined") return null;
  const own = document.currentScript as HTMLScriptElement | null;
  const script = own ?? document.querySelector<HTMLScriptElement>('script[src*="frond-view.js"]');
  return script?.src ? new URL("./", script.src).href : null;
}

const ONLY_MORPHS =
  "Only morphs are shown here, in a sandboxed frame or a file. Add allow-same-origin to the sandbox, or let the host of " +
  "Frond send Access-Control-Allow-Origin: *.";

const OBSERVED = [
  "src",
  "a",
  "b",
  "path",
  "t",
  "tool",
  "controls",
  "autoplay",
  "loop",
  "seconds",
  "locus",
  "panel",
  "verdict",
  "theme",
  "poster",
  "label",
  "studio",
] as const;
/** What changes how it looks or plays, without anything being opened anew. */
const LIGHT: readonly string[] = ["t", "controls", "loop", "seconds", "theme", "poster", "label"];

export class FrondView extends Properties {
  static readonly observedAttributes: readonly string[] = OBSERVED;

  /**
   * Where what decides and proves is, for pages that know better: an address of `frond-proof_bg.wasm`, or of
   * `frond-proof.js` beside it, or the bytes.
   */
  static get proof(): ProofSource | null {
    return saidSource();
  }
  static set proof(source: unknown) {
    sayProof(source);
  }

  readonly #shadow: Shadow;
  #shown: Shown | null = null;
  #opening = 0;
  #near = false;
  #due = false;
  #watching: (() => void) | null = null;
  #resting: ReturnType<typeof setTimeout> | undefined;
  /** The moment that was asked for before anything was there to show it. */
  #sought: number | null = null;
  /** It played when it was moved, or when what it shows changed. */
  #goesOn = false;
  /** Its first picture is there. */
  #pictured = false;
  /** Which verdict was told last, and of which moment: it is told once. */
  #heard = "";
  /** By attribute what means nothing, which is told once. */
  readonly #wrong = new Map<string, { value: string | null; message: string }>();
  /** Why nothing is shown, which is told once as well. */
  #refused = "";

  constructor() {
    super();
    const root = this.attachShadow({ mode: "open", delegatesFocus: true });
    this.#shadow = new Shadow(root, {
      seek: (t) => this.seek(t),
      toggle: () => (this.playing ? this.pause() : this.play()),
    });
  }

  connectedCallback(): void {
    for (const name of OBSERVED) this.#take(name);
    const near = new IntersectionObserver(
      (entries) => {
        this.#near = entries.at(-1)?.isIntersecting ?? false;
        this.#shown?.rest(!this.#near);
        if (this.#near && !this.#shown) this.#later();
      },
      { rootMargin: NEAR },
    );
    near.observe(this);
    const sizes = new ResizeObserver(() => this.#fit());
    sizes.observe(this.#shadow.stage);
    const dark = this.ownerDocument.defaultView?.matchMedia("(prefers-color-scheme: dark)");
    const restyle = () => this.#restyle();
    dark?.addEventListener("change", restyle);
    this.#watching = () => {
      near.disconnect();
      sizes.disconnect();
      dark?.removeEventListener("change", restyle);
    };
    this.#shadow.dress();
    this.#judgeLight();
    this.#lay();
  }

  disconnectedCallback(): void {
    this.#watching?.();
    this.#watching = null;
    this.#near = false;
    this.#close();
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (before === after || !this.isConnected) return;
    if (!LIGHT.includes(name)) {
      // Another link says its own moment.
      this.#close(name !== "src");
      this.#later();
      return;
    }
    this.#judgeLight();
    this.#lay();
    if (name === "t") this.#seekAttribute();
    else if (name === "theme") this.#restyle();
    else if (this.#shown instanceof Picture) this.#shown.choose(this.#play());
  }

  /** 0 to 1: where it is now. What is written stands in the attribute, too, and holds for the next link as well. */
  get t(): number {
    return this.#shown?.t ?? this.#sought ?? this.#moment() ?? 0;
  }

  set t(value: unknown) {
    this.write("t", textOf(value));
    // It may say so already, while the picture has moved on.
    this.#seekAttribute();
  }

  get playing(): boolean {
    return this.#shown?.playing ?? false;
  }

  /** To a moment, 0 to 1; what plays stops. */
  seek(t: number): void {
    if (!Number.isFinite(t)) return;
    const moment = Math.min(1, Math.max(0, t));
    if (this.#shown) this.#shown.seek(moment);
    else this.#sought = moment;
  }

  play(): void {
    this.#shown?.play();
  }

  pause(): void {
    this.#shown?.pause();
  }

  /** Whether it holds together at this moment. */
  readonly #told = async (): Promise<Told> => this.#ready().verdict();

  /** Called, it decides. React and its like write it, as they do with every attribute that is also a property. */
  get verdict(): () => Promise<Told> {
    return this.#told;
  }

  set verdict(said: unknown) {
    this.toggleAttribute("verdict", meansOn(said));
  }

  /** The maps at this moment: rows [a, b, c, d, e, f]. */
  maps(): number[][] {
    return this.#ready().maps();
  }

  /** A picture of this moment, on no ground. */
  async toPNG(options: PictureOptions = {}): Promise<Blob> {
    return this.#ready().picture(options);
  }

  #ready(): Shown {
    if (this.#shown) return this.#shown;
    throw new FrondError("not-ready", "It is not there yet: wait for the event ready.");
  }

  /** Null where the attribute says none. */
  #moment(): number | null {
    try {
      return momentOf(this.getAttribute("t"));
    } catch {
      // It is told once, where all attributes are judged.
      return null;
    }
  }

  #seekAttribute(): void {
    const moment = this.#moment();
    if (moment !== null) this.seek(moment);
    else if (!this.#shown && !this.hasAttribute("t")) this.#sought = null;
  }

  #judgeLight(): void {
    this.#judge(JUDGED, lightTroubles(this.#read));
  }

  readonly #read = (name: string) => this.getAttribute(name);

  /** What these attributes say that means nothing: each value is told once, and said as long as it stands there. */
  #judge(names: readonly string[], troubles: readonly WishError[]): void {
    for (const name of names)
      if (!troubles.some(({ attribute }) => attribute === name)) this.#wrong.delete(name);
    for (const { attribute, code, message } of troubles) {
      const value = this.getAttribute(attribute);
      if (this.#wrong.get(attribute)?.value === value) continue;
      this.#wrong.set(attribute, { value, message });
      // Not in the midst of what a framework is about to write: it may answer by writing more.
      queueMicrotask(() => this.#send("error", { code, message }));
    }
    this.#sayWrong();
  }

  #sayWrong(): void {
    if (this.#refused !== "") return;
    this.#shadow.say([...this.#wrong.values()][0]?.message ?? "", true);
  }

  #play() {
    return { seconds: this.seconds, loop: this.loop };
  }

  /** What was set before the element was known hides what it has of that name. */
  #take(name: (typeof OBSERVED)[number]): void {
    const said = Object.getOwnPropertyDescriptor(this, name);
    if (!said) return;
    delete (this as Partial<this>)[name];
    Object.assign(this, { [name]: said.value });
  }

  /** Once for all attributes that change together. */
  #later(): void {
    if (this.#due) return;
    this.#due = true;
    queueMicrotask(() => {
      this.#due = false;
      if (this.isConnected && this.#near && !this.#shown) void this.#open();
    });
  }

  #fail(problem: unknown): void {
    const { code, message } = errorOf(problem);
    this.#shadow.say(message);
    if (this.#refused === message) return;
    this.#refused = message;
    this.#send("error", { code, message });
  }

  #send(type: string, detail: unknown): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  async #open(): Promise<void> {
    const turn = ++this.#opening;
    const tell: Teller = {
      ready: () => turn === this.#opening && this.#arrived(),
      change: () => turn === this.#opening && this.#changed(),
      verdict: (told) => turn === this.#opening && this.#decided(told),
      error: (code, message) => {
        if (turn !== this.#opening) return;
        // A straight way is still a picture.
        if (code !== "straight") this.#shadow.say(message);
        this.#send("error", { code, message });
      },
    };
    try {
      const wish = wishOf(this.#read);
      this.#judge(WISHES, wish.troubles);
      const t = this.#sought ?? this.#moment();
      if (wish.where !== "here") {
        this.#shown = new Frame(this.#shadow.framed(this.#label()), wish, this.#framed(), t, tell);
        this.#sought = null;
        this.#understood();
        return;
      }
      const base = this.#beside();
      const proof = () => proofFrom(base);
      const choices = { ...this.#play(), ...this.#colours(), proof, calm: this.#calm() };
      const picture = await Picture.open(
        this.#shadow.drawn(),
        { fragment: wish.fragment, t, ...choices },
        tell,
      );
      if (turn !== this.#opening || !this.isConnected) {
        picture.close();
        return;
      }
      this.#shown = picture;
      this.#understood();
      // It was sought while it was opened.
      if (this.#sought !== null && this.#sought !== t) this.seek(this.#sought);
      this.#sought = null;
      this.#fit();
      this.#changed();
    } catch (problem) {
      if (turn === this.#opening) this.#fail(problem);
    }
  }

  /** What it is to show can be shown. */
  #understood(): void {
    this.#refused = "";
    this.#sayWrong();
  }

  #framed() {
    const studio = this.#studio();
    if (!studio)
      throw new WishError(
        "studio",
        'Say where the studio is: studio="https://..", the folder of its embed.html.',
      );
    // The studio's own page shows what it can this way where it is sandboxed: it has no other one to show.
    if (this.baseURI.replace(/[?#].*$/s, "") === `${studio}embed.html`)
      throw new WishError("src", ONLY_MORPHS);
    const { controls, locus, panel, autoplay, theme } = this;
    return { studio, controls, locus, panel, verdict: this.#decides, theme, autoplay };
  }

  /** Where the studio's files are; a picture does without it, so that what means nothing is but told. */
  #beside(): string | null {
    let folder = beside;
    const troubles: WishError[] = [];
    try {
      folder = this.#studio();
    } catch (problem) {
      if (!(problem instanceof WishError)) throw problem;
      troubles.push(problem);
    }
    this.#judge(["studio"], troubles);
    return folder;
  }

  #studio(): string | null {
    const said = this.getAttribute("studio")?.trim() ?? "";
    if (said === "") return beside;
    try {
      const url = new URL("./", new URL(said, this.baseURI));
      if (url.protocol === "http:" || url.protocol === "https:" || url.protocol === "file:") return url.href;
    } catch {
      // Said below.
    }
    throw new WishError("studio", "studio is the address of the folder that Frond's embed.html is in.");
  }

  /** Closes what is shown, and keeps its moment for what is shown next: an element that is moved goes on. */
  #close(keeping = true): void {
    this.#opening++;
    clearTimeout(this.#resting);
    if (this.#shown && keeping) {
      this.#sought = this.#shown.t;
      this.#goesOn = this.#shown.playing;
    }
    this.#shown?.close();
    this.#shown = null;
    this.#heard = "";
    this.#pictured = false;
    this.#shadow.clear();
  }

  #arrived(): void {
    this.#pictured = true;
    this.#shadow.arrived();
    this.#send("ready", { t: this.t });
    if (this.#goesOn || (this.autoplay && !this.#calm() && this.#shown instanceof Picture)) this.play();
    this.#goesOn = false;
    this.#changed();
  }

  #calm(): boolean {
    return this.ownerDocument.defaultView?.matchMedia("(prefers-reduced-motion: reduce)").matches ?? false;
  }

  /** Whether the verdict is to be seen: the property of that name is what decides. */
  get #decides(): boolean {
    return isOn(this.getAttribute("verdict"));
  }

  #changed(): void {
    this.#shadow.moment(this.t, this.playing);
    this.#send("change", { t: this.t, playing: this.playing });
    clearTimeout(this.#resting);
    if (!this.playing) this.#resting = setTimeout(() => this.#rested(), REST_MS);
  }

  #rested(): void {
    this.#shadow.describe(this.#label());
    // What is decided is told of what is seen.
    if (this.#decides && this.#pictured && this.#shown instanceof Picture)
      this.#shown.verdict().catch((problem) => {
        if (errorOf(problem).code === "cancelled") return;
        this.#shadow.verdict("Not decided: its module could not be fetched.");
        const { code, message } = errorOf(problem);
        this.#send("error", { code, message });
      });
  }

  #decided(told: Told): void {
    this.#shadow.verdict(this.#decides && this.#shown instanceof Picture ? told.words : "");
    const key = `${this.t} ${told.words}`;
    if (this.#heard === key) return;
    this.#heard = key;
    this.#send("verdict", told);
  }

  #label(): string {
    return this.getAttribute("label") ?? (this.#shown instanceof Picture ? this.#shown.words : "Frond");
  }

  #lay(): void {
    this.#shadow.themed();
    this.#shadow.lay(this.controls, this.poster || null, this.#label());
  }

  /** Those of the page come before those of the link, and these before those of the theme. */
  #colours(): Pick<PictureChoices, "palette" | "firm"> {
    const own = getComputedStyle(this)
      .getPropertyValue("--frond-palette")
      .match(/#[0-9a-f]{6}\b/gi);
    const theme = this.#shadow.themed();
    const colours = (own ?? palette(theme)).map((colour) => Number.parseInt(colour.slice(1), 16));
    return { palette: colours, firm: own !== null };
  }

  #restyle(): void {
    if (this.#shown instanceof Picture) this.#shown.choose(this.#colours());
    else if (this.#shown) {
      this.#close();
      this.#later();
    }
  }

  #fit(): void {
    if (!(this.#shown instanceof Picture)) return;
    const { width, height } = this.#shadow.stage.getBoundingClientRect();
    const ratio = Math.min(2, this.ownerDocument.defaultView?.devicePixelRatio ?? 1);
    this.#shown.resize(width * ratio, height * ratio);
  }
}

if (typeof customElements !== "undefined" && !customElements.get("frond-view"))
  customElements.define("frond-view", FrondView);

declare global {
  interface HTMLElementTagNameMap {
    "frond-view": FrondView;
  }
}
