/** The tiles of a window by a graphics card: block by block, the middle first. */
import { STATE } from "#geometry/states";
import type { Locus } from "#wasm/api";
import type { CardQueue, Plane } from "#wasm/locus-card";
import { type Samples, TILE, type TileId } from "../pyramid";
import { epsilonOf } from "../window";
import { judge, provedIn, type WindowWork } from "../window-job";

export type Card = Pick<CardQueue, "ask" | "pace">;

/** Tiles of one level, and a plane of samples that has all of theirs. */
interface Block {
  ids: readonly TileId[];
  x0: number;
  y0: number;
  of: Plane;
}

/** Milliseconds that the workers leave to the card before they begin with the same. */
export const PATIENCE_MS = 100;
/** A block takes about so long, so that a slow card shows one after the other. */
const BLOCK_MS = 60;
/** Samples of a block: a card answers no sooner where there are fewer. */
const LEAST_SAMPLES = 1 << 16;
/** More would need some 100 MB in all the places that they pass through. */
const MOST_SAMPLES = 1 << 22;

/** Tiles of which the card has left something open: the workers' alone. */
const hard = new WeakMap<WindowWork, Set<string>>();

const name = ({ level, i, j }: TileId): string => `${level}/${i}/${j}`;

export async function tilesByCard(card: Card, work: WindowWork, wanted: () => boolean): Promise<void> {
  const left = hard.get(work) ?? new Set();
  hard.set(work, left);
  for (;;) {
    const block = wanted() ? take(work, left, card.pace) : null;
    if (!block) return;
    // What takes long is the workers' as well: who is first is heard.
    const late = setTimeout(() => work.release(block.ids), PATIENCE_MS);
    const found = await card.ask(block.of, wanted);
    clearTimeout(late);
    if (!found) {
      work.release(block.ids);
      return;
    }
    put(work, block, found, left);
  }
}

/** Rows of the tiles that are wanted, about the one that is wanted first. */
function take(work: WindowWork, left: ReadonlySet<string>, pace: number): Block | null {
  const open = work.open.filter((id) => !left.has(name(id)));
  const first = open[0];
  if (!first) return null;
  const columns = open.map(({ i }) => i);
  const row = (Math.max(...columns) - Math.min(...columns) + 1) * TILE ** 2;
  const samples = Math.min(MOST_SAMPLES, Math.max(LEAST_SAMPLES, BLOCK_MS / pace));
  const rows = Math.max(1, Math.floor(samples / row));
  const low = first.j - (rows >> 1);
  const ids = open.filter(({ j }) => j >= low && j < low + rows);
  const places = ids.map((id) => work.pyramid.place(id));
  const span = {
    x0: Math.min(...places.map(({ x0 }) => x0)),
    y0: Math.min(...places.map(({ y0 }) => y0)),
    x1: Math.max(...places.map(({ x0, width }) => x0 + width - 1)),
    y1: Math.max(...places.map(({ y0, height }) => y0 + height - 1)),
  };
  work.hold(ids);
  return { ids, x0: span.x0, y0: span.y0, of: work.planeOf(first.level, span) };
}

/** Tiles that have something undecided are left to the workers. */
function put(work: WindowWork, { ids, x0, y0, of }: Block, found: Locus, left: Set<string>): void {
  const tiles: { id: TileId; samples: Samples }[] = [];
  const open: TileId[] = [];
  for (const id of ids) {
    const place = work.pyramid.place(id);
    const [x, y] = [place.x0 - x0, place.y0 - y0];
    const samples = part(found, x, y, place.width, place.height);
    judge(samples, samples, epsilonOf(id.level), provedIn({ x0: x, y0: y, x1: x + place.width, of }));
    if (samples.state.includes(STATE.undecided)) open.push(id);
    else tiles.push({ id, samples });
  }
  for (const id of open) left.add(name(id));
  work.release(open);
  work.put(tiles);
}

/** A rectangle of samples. */
function part(
  { state, gap, width: all }: Locus,
  x: number,
  y: number,
  width: number,
  height: number,
): Samples {
  const samples = {
    width,
    state: new Uint8Array(width * height),
    gap: new Float32Array(width * height),
  };
  for (let row = 0; row < height; row++) {
    const from = (y + row) * all + x;
    samples.state.set(state.subarray(from, from + width), row * width);
    samples.gap.set(gap.subarray(from, from + width), row * width);
  }
  return samples;
}
