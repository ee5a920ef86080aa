import type { CDPSession, Page } from "@playwright/test";

/** A finger that is put down, moved and lifted, as the browser's own touch events. */
export class Finger {
  readonly #session: CDPSession;

  private constructor(session: CDPSession) {
    this.#session = session;
  }

  static async of(page: Page): Promise<Finger> {
    return new Finger(await page.context().newCDPSession(page));
  }

  async drag(from: { x: number; y: number }, to: { x: number; y: number }, steps = 6): Promise<void> {
    await this.#send("touchStart", [from]);
    for (let i = 1; i <= steps; i++) {
      const s = i / steps;
      await this.#send("touchMove", [{ x: from.x + s * (to.x - from.x), y: from.y + s * (to.y - from.y) }]);
    }
    await this.#send("touchEnd", []);
  }

  async tap(at: { x: number; y: number }): Promise<void> {
    await this.#send("touchStart", [at]);
    await this.#send("touchEnd", []);
  }

  /** A finger drags, and before it is lifted a second one comes, and they part. */
  async dragThenJoin(
    from: { x: number; y: number },
    to: { x: number; y: number },
    apart: number,
    then: number,
  ): Promise<void> {
    await this.#send("touchStart", [from]);
    await this.#send("touchMove", [{ x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 }]);
    await this.#send("touchMove", [to]);
    await this.#part(to, apart, then);
  }

  /** A second finger comes down beside one that rests, and parts from it. */
  async join(first: { x: number; y: number }, apart: number, then: number): Promise<void> {
    await this.#send("touchStart", [first]);
    await this.#part(first, apart, then);
  }

  async #part(first: { x: number; y: number }, apart: number, then: number, steps = 6): Promise<void> {
    const both = (d: number) => [first, { x: first.x + d, y: first.y }];
    await this.#send("touchStart", both(apart));
    for (let i = 1; i <= steps; i++)
      await this.#send("touchMove", both(apart + (i / steps) * (then - apart)));
    await this.#send("touchEnd", []);
  }

  /** Two fingers that part from, or come to, the middle between them. */
  async pinch(at: { x: number; y: number }, apart: number, then: number, steps = 6): Promise<void> {
    const both = (d: number) => [
      { x: at.x - d / 2, y: at.y },
      { x: at.x + d / 2, y: at.y },
    ];
    await this.#send("touchStart", both(apart));
    for (let i = 1; i <= steps; i++)
      await this.#send("touchMove", both(apart + (i / steps) * (then - apart)));
    await this.#send("touchEnd", []);
  }

  async #send(type: "touchStart" | "touchMove" | "touchEnd", points: { x: number; y: number }[]) {
    await this.#session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: points.map((point, id) => ({ ...point, id })),
    });
  }
}
