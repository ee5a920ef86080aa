/** `import "frond-ifs/view"` defines the element `<frond-view>`; in a page, the script alone does. */

export interface Told {
  verdict: "connected" | "touching" | "disconnected" | "undecided" | "no-attractor";
  /** As the studio says it: "In one piece, proved". */
  words: string;
}

/** Detail of the event `error`. */
export interface Trouble {
  /** Stays the same over versions. */
  code: string;
  message: string;
}

/**
 * A morph, or whatever else the studio shows. Attributes: `src`, or `a`, `b` and `path`; `t`, `controls`, `autoplay`,
 * `loop`, `seconds`, `verdict`, `theme`, `poster`, `label`; and by the studio `tool`, `locus`, `panel`; `studio`.
 * Events: `ready` { t }, `change` { t, playing }, `verdict` (`Told`), `error` (`Trouble`).
 */
export interface FrondView extends HTMLElement {
  /** The moment, 0 to 1. It is set as a number or as text, as frameworks do with what stands in an attribute. */
  get t(): number;
  set t(moment: number | string);
  readonly playing: boolean;
  src: string | null;
  /** To a moment, 0 to 1; what plays stops. */
  seek(t: number): void;
  play(): void;
  pause(): void;
  /** Whether it holds together at this moment. Rejects with a `Trouble`. */
  verdict(): Promise<Told>;
  /** The maps at this moment, rows [a, b, c, d, e, f]. Throws a `Trouble` where there are none. */
  maps(): number[][];
  /** A picture of this moment on no ground, sides of 1 to 8192 pixels. Rejects with a `Trouble`. */
  toPNG(options?: { width?: number; height?: number }): Promise<Blob>;
}

declare global {
  interface HTMLElementTagNameMap {
    "frond-view": FrondView;
  }
}
