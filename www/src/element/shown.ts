/** What an element shows: a picture of its own, or a frame of the studio. */
export interface Told {
  verdict: string;
  /** As the studio says it. */
  words: string;
}

export interface PictureOptions {
  width?: number;
  height?: number;
}

export interface Shown {
  readonly t: number;
  readonly playing: boolean;
  seek(t: number): void;
  play(): void;
  pause(): void;
  /** Whether it holds together at this moment. */
  verdict(): Promise<Told>;
  /** The maps at this moment, rows of six. */
  maps(): number[][];
  picture(options: PictureOptions): Promise<Blob>;
  /** It is off the screen, or on it again: off it nothing is drawn. */
  rest(away: boolean): void;
  close(): void;
}

/** What is shown tells the element of it. */
export interface Teller {
  ready(): void;
  change(): void;
  verdict(told: Told): void;
  error(code: string, message: string): void;
}
