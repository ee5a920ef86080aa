/** Systems of space from files, and for Fractint. */
import { notify, wordsOf } from "#document/notice";
import { setView, space } from "#document/space/space";
import { download, plainName } from "#ui/files/download";
import type { MapRow3, SpaceView } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "../messages";
import { object, parameters } from "../now";
import { take } from "./take";

/** Alone, or beside what there is where that is several: no object of several leaves unasked. */
export function takeFound(
  { name, maps }: { name: string; maps: MapRow3[] },
  said: string,
  view: SpaceView | null = null,
): void {
  const several = (space.peek()?.objects.length ?? 1) > 1;
  const there = several
    ? messages.addedWithMaps(name, maps.length)
    : messages.replacedWithMaps(name, maps.length);
  take([{ name, maps }], several ? "beside" : "alone", `${there} ${said}`.trim(), { aloud: true });
  if (view && !several) setView(view);
}

/** A shape of several systems, each an object: they lie where they lie to each other, and so they come alone. */
export function takeAll(
  name: string,
  all: readonly MapRow3[][],
  said: string,
  view: SpaceView | null = null,
): void {
  const objects = all.map((maps, k) => ({ name: messages.partOf(name, k + 1), maps }));
  const there = messages.aloneInObjects(name, all.length);
  take(objects, "alone", `${there} ${said}`.trim(), { aloud: true });
  if (view) setView(view);
}

/** Saves the parameters as they are now: what was done to the object is in them. */
export function saveFile(): void {
  const name = object.peek()?.name ?? messages.shape;
  try {
    const text = solid.writeIfs3(name, parameters.peek());
    download(new Blob([text], { type: "text/plain" }), `frond-${plainName(name, "shape", 32)}.ifs`);
  } catch (problem) {
    notify({ kind: "error", text: messages.objectNotSaved(name, wordsOf(problem)) });
  }
}
