import type { Locator, Page } from "@playwright/test";
import type { Studio } from "./studio";

/** A point of the page. */
export interface At {
  x: number;
  y: number;
}

const HANDLE = /^Column \d+, row \d+:/;

/** The control mesh on the stage. */
export class Grid {
  readonly #page: Page;
  readonly #studio: Studio;

  constructor(page: Page, studio: Studio) {
    this.#page = page;
    this.#studio = studio;
  }

  async open(fragment = "v=1&a=gasket&b=gasket&path=straight&tool=deform"): Promise<void> {
    await this.#studio.open(fragment);
    await this.handle(1, 1).waitFor();
    await this.#studio.drawn();
  }

  get handles(): Locator {
    return this.#page.getByRole("button", { name: HANDLE });
  }

  handle(column: number, row: number): Locator {
    return this.#page.getByRole("button", { name: new RegExp(`^Column ${column}, row ${row}:`) });
  }

  async place(column: number, row: number): Promise<At> {
    const box = await this.handle(column, row).boundingBox();
    if (!box) throw new Error("the handle is not on the page");
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  async drag(from: At, dx: number, dy: number): Promise<void> {
    const { mouse } = this.#page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move(from.x + dx / 2, from.y + dy / 2, { steps: 3 });
    await mouse.move(from.x + dx, from.y + dy, { steps: 3 });
    await mouse.up();
  }

  /** dx, dy of a control point; nothing where the document has no mesh. */
  async moved(column: number, row: number): Promise<number[]> {
    const { deform } = await this.#studio.scene();
    if (!deform) return [0, 0];
    const i = 2 * ((row - 1) * deform.columns + column - 1);
    return deform.keys[0]?.moves.slice(i, i + 2) ?? [];
  }

  /** Of how many control points the document says that they are moved. */
  async count(): Promise<number> {
    const { deform } = await this.#studio.scene();
    const moves = deform?.keys[0]?.moves ?? [];
    return moves.filter((x, i) => i % 2 === 0 && (x !== 0 || moves[i + 1] !== 0)).length;
  }

  chosen(): Promise<number> {
    return this.#page.getByRole("button", { name: HANDLE, pressed: true }).count();
  }
}
