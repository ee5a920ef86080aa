/** Asks the worker that reads QR codes. */
import type { Answer, Ask } from "./codes.worker";
import type { Care } from "./read";

/** Reads codes until it is closed. */
export class CodeReader {
  readonly #worker = new Worker(new URL("./codes.worker.ts", import.meta.url), {
    type: "module",
    name: "frond-codes",
  });
  readonly #waiting = new Map<
    number,
    { resolve: (texts: string[]) => void; reject: (problem: Error) => void }
  >();
  #next = 1;

  constructor() {
    this.#worker.onmessage = ({ data: { id, texts } }: MessageEvent<Answer>) => {
      this.#waiting.get(id)?.resolve(texts);
      this.#waiting.delete(id);
    };
    this.#worker.onerror = () => this.#end("What reads QR codes could not be loaded. Is there a connection?");
  }

  /** The texts of all codes in a picture, which is taken over. */
  read(picture: ImageBitmap, care: Care): Promise<string[]> {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.#worker.postMessage({ id, picture, care } satisfies Ask, [picture]);
    });
  }

  close(): void {
    this.#worker.terminate();
    this.#end("No codes are read any more.");
  }

  #end(why: string): void {
    for (const { reject } of this.#waiting.values()) reject(new Error(why));
    this.#waiting.clear();
  }
}
