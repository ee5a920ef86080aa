import { useEffect, useMemo, useState } from "preact/hooks";
import { thumbnails } from "#compute/results";
import { thumbnailsOf } from "#compute/thumbnails";
import { directedPicture } from "#stage/directed/thumb";
import { stageStyle } from "#stage/picture-style";
import { Segmented } from "#ui/controls/Segmented";
import { Dialog } from "#ui/overlay/Dialog";
import { mapsNote, ShapeGrid } from "#ui/shapes/ShapeGrid";
import type { ImportedSystem } from "#wasm/api";
import { loadSpace } from "#wasm/space";
import { type Choice, choice, take } from "./door";
import * as messages from "./messages";
import type { Where } from "./morph";
import css from "./picker.module.css";

/** Pictures that are made at a time: more are found by their name. */
const MOST_SHOWN = 60;
/** From so many on, a field looks for names. */
const MANY = 13;
/** Of pictures of graph-directed shapes. */
const SIZE = { width: 160, height: 120 };

type Item = ImportedSystem & { id: string; about: string };

/** The systems of a file, one of which is opened. */
export function Picker() {
  const { file, systems, remarks } = choice.value ?? NOTHING;
  const [where, setWhere] = useState<Where>("a");
  const [sought, setSought] = useState("");
  const [solids, setSolids] = useState<ReadonlyMap<string, ImageBitmap>>(new Map());
  const [graphs, setGraphs] = useState<ReadonlyMap<string, ImageBitmap>>(new Map());
  const items: Item[] = useMemo(() => {
    turn++;
    return systems.map((system, i) => ({
      ...system,
      // Pictures of an earlier file have other ids.
      id: `file-${turn}-${i}`,
      name: system.name || messages.systemNumber(i + 1),
      about: system.problem ?? system.remarks.join(" ") ?? "",
    }));
  }, [systems]);
  const found = useMemo(() => named(items, sought), [items, sought]);
  const shown = useMemo(() => found.slice(0, MOST_SHOWN), [found]);
  useEffect(
    () =>
      thumbnailsOf(
        shown.flatMap((one) => (one.dimension === 2 && !one.states ? [{ id: one.id, maps: one.maps }] : [])),
      ),
    [shown],
  );
  const { colouring, palette } = stageStyle.value;
  useEffect(() => {
    const ended = new AbortController();
    for (const one of shown) {
      if (one.dimension === 3 || !one.states || one.problem !== undefined) continue;
      directedPicture({ states: one.states }, SIZE, { colouring, palette }, ended.signal).then(
        (made) => {
          if (made && !ended.signal.aborted) setGraphs((before) => new Map(before).set(one.id, made));
        },
        // Without a picture it can still be chosen.
        () => {},
      );
    }
    return () => ended.abort();
  }, [shown, colouring, palette]);
  useEffect(() => solidPictures(shown, setSolids), [shown]);
  const close = () => {
    choice.value = null;
  };
  return (
    <Dialog
      wide
      title={file}
      about={[messages.thisFileContainsSystems(systems.length), ...remarks].join(" ")}
      onClose={close}
    >
      <div class={css["head"]}>
        {items.some(({ dimension }) => dimension === 2) && (
          <Segmented<Where>
            label={messages.openAs}
            value={where}
            onChange={setWhere}
            options={[
              { value: "a", label: messages.as, description: messages.shapeMorphStartsWith },
              { value: "b", label: messages.asB, description: messages.shapeMorphEndsWith },
              { value: "both", label: messages.asBoth, description: messages.atBothEnds },
            ]}
          />
        )}
        {items.length >= MANY && (
          <input
            type="search"
            class={css["search"]}
            aria-label={messages.searchByName}
            placeholder={messages.searchByName}
            value={sought}
            onInput={(event) => setSought(event.currentTarget.value)}
          />
        )}
      </div>
      {found.length > shown.length && (
        <p class="hint">{messages.showingSearchByName(shown.length, found.length)}</p>
      )}
      <p class="unseen" role="status">
        {sought && messages.foundCount(found.length)}
      </p>
      {found.length === 0 && <p class="hint">{messages.noSystemHasName}</p>}
      <ShapeGrid
        key={sought}
        presets={shown}
        pictures={
          solids.size + graphs.size > 0
            ? new Map([...thumbnails.value, ...solids, ...graphs])
            : thumbnails.value
        }
        noteOf={noteOf}
        chosen={undefined}
        onChoose={(item) => {
          close();
          void take(file, item, [], where);
        }}
      />
    </Dialog>
  );
}

/** Of what it is made. */
function noteOf(item: Item): string {
  if (item.dimension === 2) return item.states ? messages.statesNote(item.states.length) : mapsNote(item);
  return messages.inSpace(item.objects ? messages.objectsNote(item.objects.length) : mapsNote(item));
}

/** How many files were looked at. */
let turn = 0;

/** Pictures of those of space, carved by a worker that is fetched for it, until the returned function is called. */
function solidPictures(
  shown: readonly Item[],
  give: (pictures: ReadonlyMap<string, ImageBitmap>) => void,
): () => void {
  const subjects = shown.flatMap(({ id, name, problem, ...system }) =>
    system.dimension === 3 && problem === undefined
      ? [{ id, objects: (system.objects ?? [system.maps]).map((maps) => ({ name, maps })) }]
      : [],
  );
  let stops: (() => void)[] = [];
  let gone = false;
  if (subjects.length > 0) {
    Promise.all([import("#tools/space/shape/object/thumbs"), loadSpace()]).then(
      ([{ makePictures, pictures }]) => {
        if (!gone) stops = [pictures.subscribe(give), makePictures(subjects)];
      },
      // Without pictures they can still be chosen.
      () => {},
    );
  }
  return () => {
    gone = true;
    for (const stop of stops) stop();
  };
}

/** Those with these letters in their name. */
function named(items: readonly Item[], sought: string): Item[] {
  const wanted = sought.trim().toLowerCase();
  return items.filter(({ name }) => name.toLowerCase().includes(wanted));
}

const NOTHING: Choice = { file: "", systems: [], remarks: [] };
