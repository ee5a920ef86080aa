import { useEffect, useMemo, useState } from "preact/hooks";
import type { SpaceObject } from "../../../engine/api";
import { solid } from "../../../engine/space/module";
import { standing } from "../../../state/morph";
import { scene } from "../../../state/scene";
import { space } from "../../../state/space";
import { Dialog } from "../../../ui/Dialog";
import { Segmented } from "../../../ui/Segmented";
import { mapsNote, ShapeGrid, type ShapeItem } from "../../../ui/ShapeGrid";
import { object } from "./now";
import { presets } from "./presets";
import { type How, take } from "./take";
import { makePictures, pictures } from "./thumbs";

interface Item extends ShapeItem {
  objects: SpaceObject[];
}

const NATURAL = "natural-scene";
const PLANE = "from-the-plane";

/** Everything that can be chosen: the gallery, a scene of several objects, and what the plane shows. */
function items(): Item[] {
  const all: Item[] = presets().map(({ id, name, about, maps }) => ({
    id,
    name,
    about,
    objects: [{ preset: id, name, maps }],
  }));
  const { name } = scene.peek().a;
  return [
    ...all,
    {
      id: NATURAL,
      name: "A natural scene",
      about: "Hills, trees, ferns and clouds, all of them attractors, with the eye at the origin.",
      objects: solid.naturalScene(),
    },
    {
      id: PLANE,
      name: `${name}, from the plane`,
      about: "What the Morph tool shows, as a sheet of no thickness at z = 0.",
      objects: [{ name, maps: solid.lift(standing.peek()) }],
    },
  ];
}

function note({ objects }: Item): string {
  const [first] = objects;
  return objects.length > 1 || !first ? `${objects.length} objects` : mapsNote(first);
}

/** Shapes to begin with, to put in the place of an object, or to add. */
export function Gallery({ how: first, onClose }: { how: How; onClose: () => void }) {
  const [how, setHow] = useState<How>(first);
  const all = useMemo(items, []);
  useEffect(() => makePictures(all), [all]);
  const now = object.value;
  const several = (space.value?.objects.length ?? 1) > 1;
  // A scene cannot stand in the place of one of its own objects.
  const shown = how === "instead" ? all.filter(({ objects }) => objects.length === 1) : all;
  return (
    <Dialog
      wide
      title="Shapes of space"
      about="Each is a handful of maps, and nothing else."
      onClose={onClose}
    >
      <div class="solid-how">
        <Segmented
          label="What becomes of what there is"
          value={how}
          onChange={setHow}
          options={[
            {
              value: "alone",
              label: "Alone",
              description: "Begin anew with it: neither morph nor time line stays",
            },
            { value: "instead", label: several ? `Instead of ${now?.name}` : "Instead" },
            { value: "beside", label: "Beside" },
          ]}
        />
        <p class="hint">{WORDS[how]}</p>
      </div>
      <ShapeGrid
        presets={shown}
        pictures={pictures.value}
        noteOf={note}
        chosen={several ? (now?.preset?.startsWith("natural-") ? NATURAL : undefined) : now?.preset}
        onChoose={({ name, objects }) => {
          take(objects, how, `${name}: ${WORDS[how]}`);
          onClose();
        }}
      />
    </Dialog>
  );
}

const WORDS: Record<How, string> = {
  alone: "A new beginning: all that was there leaves, and Undo brings it back.",
  instead: "It takes the place of the chosen object, moved and coloured as that is.",
  beside: "It stands beside what there is.",
};
