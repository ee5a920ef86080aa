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
  a?: Shape | null | undefined;
  b?: Shape | null | undefined;
  path?: Path | null | undefined;
  /** The moment, 0 to 1. */
  t?: number | string | null | undefined;
  /** From one end to the other, 0.5 to 600; 8 where nothing is said. */
  seconds?: number | string | null | undefined;
  controls?: Switch | null | undefined;
  autoplay?: Switch | null | undefined;
  loop?: Switch | null | undefined;
  /** Whether its verdict is shown on it. */
  verdict?: Switch | null | undefined;
  theme?: "light" | "dark" | "auto" | (string & {}) | null | undefined;
  /** A picture that is shown until its own is there. */
  poster?: string | null | undefined;
  /** What it is called for who does not see it. */
  label?: string | null | undefined;
  /** The folder of the studio's embed.html, which shows the rest in a frame. */
  studio?: string | URL | null | undefined;
  tool?: "morph" | "deform" | "fit" | "space" | (string & {}) | null | undefined;
  locus?: Switch | null | undefined;
  panel?: Switch | null | undefined;
}

/** The events and what their `detail` is. */
export interface ViewEvents {
  ready: CustomEvent<{ t: number }>;
  change: CustomEvent<{ t: number; playing: boolean }>;
  verdict: CustomEvent<Told>;
  error: CustomEvent<Trouble>;
}

/** A morph, or whatever else the studio shows. */
export class FrondView extends HTMLElement {
  /**
   * Where the module is that decides and proves, if not beside the element: the address of `frond-proof_bg.wasm`, or its
   * bytes, both of the same version. For notebooks and other places where a module cannot bring files along.
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

  readonly playing: boolean;
  /** To a moment, 0 to 1; what plays stops. */
  seek(t: number): void;
  play(): void;
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
