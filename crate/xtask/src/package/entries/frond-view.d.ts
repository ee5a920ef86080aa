/** `import "frond-ifs/view"` defines the element `<frond-view>`; in a page, the script `frond-view.js` alone does. */

export interface Told {
  verdict: "connected" | "touching" | "disconnected" | "undecided" | "no-attractor";
  /** As the studio says it: "In one piece, proved". */
  words: string;
}

/** Detail of the event `error`. What is thrown and rejected is an Error with the name `FrondError` that has both. */
export interface Trouble {
  /** Stays the same over versions. */
  code: string;
  message: string;
}

type Numbers = readonly number[] | Float32Array | Float64Array;

/**
 * A shape: its name in the gallery, or its maps, at most 64: rows [a, b, c, d, e, f], matrices [[a, b, e], [c, d, f]],
 * all numbers one after the other, an object that has them as `maps`, or any of these as JSON.
 */
export type Shape =
  | string
  | Numbers
  | readonly (Numbers | readonly Numbers[])[]
  | { readonly maps: readonly Numbers[] };

/** `"auto"`, `"straight"`, points as text, `"0.1,0.8; 0.4,1.2"`, or the points themselves. */
export type Path = string | readonly Numbers[];

/** What is on or off: `""` is on, as in markup, and `"false"` is off. */
export type Switch = boolean | "" | "true" | "false";

/**
 * What may stand in markup, in JSX and in templates. All of it may be set as a property, too, by the same names, and
 * `null` takes it away. A value that means nothing is told by one event `error`, and the rest is shown.
 */
export interface ViewAttributes {
  /** A link of Frond, or what stands behind its #. */
  src?: string | URL | null | undefined;
  /** The shape at t = 0: the name of one in the gallery, or maps as JSON. */
  a?: Shape | null | undefined;
  /** The shape at t = 1, written like `a`. */
  b?: Shape | null | undefined;
  /** How the morph goes from `a` to `b`: `auto`, `straight`, or points such as `0.1,0.8; 0.4,1.2`. */
  path?: Path | null | undefined;
  /** The moment, 0 to 1. */
  t?: number | string | null | undefined;
  /** How many seconds one way takes, 0.5 to 600. The default is 8. */
  seconds?: number | string | null | undefined;
  /** Shows a slider and a button that plays. */
  controls?: Switch | null | undefined;
  /** Plays at once, except for people who prefer reduced motion. */
  autoplay?: Switch | null | undefined;
  /** Plays back and forth without end. */
  loop?: Switch | null | undefined;
  /** Says at rest whether the shape is in one piece. */
  verdict?: Switch | null | undefined;
  /** Light or dark; `auto` follows the system. Without it the color-scheme of the page decides. */
  theme?: "light" | "dark" | "auto" | (string & {}) | null | undefined;
  /** A picture that is shown until its own is there. */
  poster?: string | null | undefined;
  /** What screen readers say of it. */
  label?: string | null | undefined;
  /** The folder of the studio's embed.html, which shows the rest in a frame. */
  studio?: string | URL | null | undefined;
  /** The tool of the studio that shows the link in `src`, in a frame. */
  tool?: "morph" | "deform" | "fit" | "space" | (string & {}) | null | undefined;
  /** Shows the map of the parameters beside the picture, in a frame of the studio. */
  locus?: Switch | null | undefined;
  /** Shows the panel of the tool, in a frame of the studio. */
  panel?: Switch | null | undefined;
}

/** The events and what their `detail` is. */
export interface ViewEvents {
  /** The first picture is there. */
  ready: CustomEvent<{ t: number }>;
  /** The moment changed, or it began or stopped to play. */
  change: CustomEvent<{ t: number; playing: boolean }>;
  /** It decided whether the shape holds together at this moment. */
  verdict: CustomEvent<Told>;
  /** Something could not be shown, or a value means nothing. */
  error: CustomEvent<Trouble>;
}

/**
 * A morph between two shapes, a single shape, or a link of the studio.
 *
 * @cssproperty [--frond-background] - The colour behind the picture.
 * @cssproperty [--frond-ink] - The colour of words and signs.
 * @cssproperty [--frond-accent] - The colour of the slider.
 * @cssproperty [--frond-radius=0.5rem] - The radius of the corners.
 * @cssproperty [--frond-palette] - The colours of the maps, `#rrggbb`, with spaces or commas between them.
 * @csspart all - All of it.
 * @csspart stage - What holds the picture and the words over it.
 * @csspart picture - The canvas.
 * @csspart poster - The image until the first picture is there.
 * @csspart message - What it says when there is nothing to show.
 * @csspart verdict - Whether the shape is in one piece.
 * @csspart controls - The row below the picture.
 * @csspart play - The button that plays and pauses.
 * @csspart slider - The slider of the moment.
 * @csspart frame - The frame of the studio, where `src` needs one.
 */
export class FrondView extends HTMLElement {
  /**
   * Where the module is that decides and proves, if not beside the element: the address of `frond-proof_bg.wasm`, or
   * its bytes, both of the same version. For notebooks and other places where a module cannot bring files along.
   */
  static get proof(): string | URL | BufferSource | WebAssembly.Module | null;
  static set proof(source: string | URL | BufferSource | WebAssembly.Module | null);

  get src(): string | null;
  set src(link: ViewAttributes["src"]);
  /** As text: the name of a shape, or maps as JSON. */
  get a(): string | null;
  set a(shape: ViewAttributes["a"]);
  get b(): string | null;
  set b(shape: ViewAttributes["b"]);
  get path(): string | null;
  set path(path: ViewAttributes["path"]);
  /** Where it is now, 0 to 1. What is written stands in the attribute as well, and holds for the next link, too. */
  get t(): number;
  set t(moment: ViewAttributes["t"]);
  get seconds(): number;
  set seconds(seconds: ViewAttributes["seconds"]);
  get controls(): boolean;
  set controls(on: ViewAttributes["controls"]);
  get autoplay(): boolean;
  set autoplay(on: ViewAttributes["autoplay"]);
  get loop(): boolean;
  set loop(on: ViewAttributes["loop"]);
  get theme(): string | null;
  set theme(theme: ViewAttributes["theme"]);
  get poster(): string | null;
  set poster(address: ViewAttributes["poster"]);
  get label(): string | null;
  set label(label: ViewAttributes["label"]);
  get studio(): string | null;
  set studio(folder: ViewAttributes["studio"]);
  get tool(): string | null;
  set tool(tool: ViewAttributes["tool"]);
  get locus(): boolean;
  set locus(on: ViewAttributes["locus"]);
  get panel(): boolean;
  set panel(on: ViewAttributes["panel"]);

  /** Whether it plays now. */
  readonly playing: boolean;
  /** To a moment, 0 to 1; what plays stops. */
  seek(t: number): void;
  /** Plays from where it is. */
  play(): void;
  /** Stops where it is. */
  pause(): void;
  /**
   * Whether it holds together at this moment. Rejects with a `FrondError`. Frameworks write the attribute of this name
   * by this property, which switches whether the verdict is shown.
   */
  get verdict(): () => Promise<Told>;
  set verdict(on: (() => Promise<Told>) | ViewAttributes["verdict"]);
  /** The maps at this moment, rows [a, b, c, d, e, f]. Throws a `FrondError` where there are none. */
  maps(): number[][];
  /** A picture of this moment on no ground, sides of 1 to 8192 pixels. Rejects with a `FrondError`. */
  toPNG(options?: { width?: number; height?: number }): Promise<Blob>;

  addEventListener<Name extends keyof ViewEvents>(
    type: Name,
    listener: (this: FrondView, event: ViewEvents[Name]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener<Name extends Exclude<keyof HTMLElementEventMap, keyof ViewEvents>>(
    type: Name,
    listener: (this: FrondView, event: HTMLElementEventMap[Name]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "frond-view": FrondView;
  }
}
