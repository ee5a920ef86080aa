/** The picture on the stage in sentences, for those who do not see it. */
import { verdict } from "#compute/results";
import { boxOf, stageTrack } from "#document/framing";
import { ranks, selection, shown, shownPick } from "#document/morph";
import { scene } from "#document/scene";
import { endsOf, standIn, standInWords } from "#document/stand-in";
import { percent } from "#format/path-words";
import { type Described, shapeWords, sizeWords } from "#format/shape-words";
import { boxAt } from "#geometry/boxes";
import { type Looks, looksOf } from "#geometry/holes";
import { symmetriesOf } from "#geometry/maps/symmetries";
import { palette } from "#style/palette";
import type { Connectedness, MapRow } from "#wasm/api";
import { submit } from "#workers/pool/engine";
import { single } from "#workers/pool/protocol";
import * as messages from "./messages";

/** Pixels a side: holes that a glance sees. */
const SIDE = 200;
const PRIORITY = 50;

/** What is on the stage is called. */
function nameNow(): string {
  const { t, ...rest } = scene.peek();
  const { a, b } = endsOf({ t, ...rest });
  const editing = selection.peek()?.target;
  if (editing) return rest[editing].name;
  if (t === 0 || t === 1) return (t === 0 ? a : b).name;
  return messages.fromToOnPath(a.name, b.name, percent(t));
}

export async function describeStage(): Promise<string> {
  if (standIn.peek()) {
    const box = boxAt(stageTrack.peek(), scene.peek().t);
    return `${nameNow()}: ${standInWords.peek()}, ${sizeWords(box)}.`;
  }
  // An end has the maps that it has by itself, which the morph may have split, and numbers otherwise.
  const { t } = scene.peek();
  const editing = selection.peek();
  const end = editing || shownPick.peek() || (t !== 0 && t !== 1) ? null : t === 0 ? "a" : "b";
  const maps = end ? scene.peek()[end].maps : shown.peek();
  const places = end ? ranks[end].peek() : maps.map((_, i) => i);
  const known = verdict.peek();
  const facts: Described = {
    name: nameNow(),
    maps,
    box: boxOf(maps),
    symmetries: symmetriesOf(maps),
    answer: known && !known.stale ? numbered(known.connectedness, places) : null,
    looks: null,
  };
  return shapeWords({ ...facts, looks: await looks(maps).catch(() => null) });
}

/** The pairs by the numbers of the shape's own maps; none where others were looked at. */
function numbered({ verdict, overlaps, components }: Connectedness, places: readonly number[]) {
  if (components.length !== places.length) return { verdict, overlaps: [] };
  const own = overlaps.map(([i, j]): [number, number] => {
    const [p, q] = [places.indexOf(i), places.indexOf(j)];
    return p < q ? [p, q] : [q, p];
  });
  return { verdict, overlaps: own.sort(([i, j], [p, q]) => i - p || j - q) };
}

/** A small picture of it, looked at pixel by pixel. */
async function looks(maps: MapRow[]): Promise<Looks | null> {
  const options = { width: SIDE, height: SIDE, colouring: "map" as const, palette: palette("light") };
  const image = await new Promise<ImageBitmap>((accept, fail) =>
    submit(single<"picture">("describe", PRIORITY, { kind: "picture", maps, options }, { accept, fail })),
  );
  const context = new OffscreenCanvas(SIDE, SIDE).getContext("2d", { willReadFrequently: true });
  if (!context) return null;
  context.drawImage(image, 0, 0);
  image.close();
  const { data } = context.getImageData(0, 0, SIDE, SIDE);
  const lit = Array.from({ length: SIDE * SIDE }, (_, i) => (data[4 * i + 3] ?? 0) > 127);
  return looksOf(lit, SIDE, SIDE);
}
