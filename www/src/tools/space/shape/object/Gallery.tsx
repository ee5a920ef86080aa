import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { standing } from "#document/morph";
import { scene } from "#document/scene";
import type { Look } from "#document/space/edits";
import { space } from "#document/space/space";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { Dialog } from "#ui/overlay/Dialog";
import { mapsNote, ShapeGrid, type ShapeItem } from "#ui/shapes/ShapeGrid";
import type { SpaceObject } from "#wasm/api";
import { solid } from "#wasm/space";
import { object } from "../now";
import shapeCss from "../shape.module.css";
import { presets } from "./presets";
import { type How, take, takenWords } from "./take";
import { makePictures, pictures } from "./thumbs";

interface Item extends ShapeItem {
  objects: SpaceObject[];
  /** Its own light and sky. */
  look?: Look;
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
  const natural = solid.naturalSpace();
  return [
    ...all,
    {
      id: NATURAL,
      name: "A natural scene",
      about:
        "Hills, trees with bark and leaves, ferns and clouds in evening light, all of them attractors, with the eye at the origin.",
      objects: natural.objects,
      look: natural,
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

/**
 * Shapes to begin with, to put in the place of an object, or to add. Where nobody has said which of these (`ask`), that
 * is asked once a shape is chosen: no object of several leaves unasked.
 */
export function Gallery({ how: first, onClose }: { how: How | "ask"; onClose: () => void }) {
  const [how, setHow] = useState<How | "ask">(first);
  const [asked, setAsked] = useState<Item | null>(null);
  const all = useMemo(items, []);
  useEffect(() => makePictures(all), [all]);
  const now = object.value;
  const several = (space.value?.objects.length ?? 1) > 1;
  // A scene cannot stand in the place of one of its own objects.
  const shown = how === "instead" ? all.filter(({ objects }) => objects.length === 1) : all;
  const takeIn = ({ name, objects, look }: Item, where: How) => {
    take(objects, where, takenWords(name, where, now?.name ?? ""), { look });
    onClose();
  };
  const grid = useRef<HTMLDivElement>(null);
  // Back from the question, keys go on where they were.
  const back = () => {
    setAsked(null);
    requestAnimationFrame(() => grid.current?.querySelector<HTMLElement>('[tabindex="0"]')?.focus());
  };
  return (
    <Dialog
      wide
      title={asked ? `Where is ${asked.name} to stand?` : "Shapes of space"}
      about={asked ? "Nothing has changed so far." : "Each is a handful of maps, and nothing else."}
      onClose={onClose}
    >
      {asked && (
        <Question
          item={asked}
          instead={now?.name ?? ""}
          count={space.value?.objects.length ?? 1}
          onTake={(where) => takeIn(asked, where)}
          onBack={back}
        />
      )}
      <div ref={grid} hidden={asked !== null}>
        <div class={shapeCss["solid-how"]}>
          <Segmented<How | "ask">
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
          chosen={several ? (now?.preset?.startsWith("evening-") ? NATURAL : undefined) : now?.preset}
          onChoose={(item) => {
            if (how === "ask") setAsked(item);
            else takeIn(item, how);
          }}
        />
      </div>
    </Dialog>
  );
}

interface QuestionProps {
  item: Item;
  /** The name of the object that would leave. */
  instead: string;
  count: number;
  onTake: (how: How) => void;
  onBack: () => void;
}

/** What is to become of the objects that there are, for a shape that has been chosen. */
function Question({ item, instead, count, onTake, onBack }: QuestionProps) {
  const first = useRef<HTMLButtonElement>(null);
  useEffect(() => first.current?.focus(), []);
  return (
    <ul class={shapeCss["solid-systems"]}>
      <li>
        <Button kind="primary" buttonRef={first} onClick={() => onTake("beside")}>
          Beside what there is <span class={shapeCss["solid-fate"]}>all {count} stay</span>
        </Button>
      </li>
      {item.objects.length === 1 && (
        <li>
          <Button onClick={() => onTake("instead")}>
            Instead of {instead} <span class={shapeCss["solid-fate"]}>{instead} leaves</span>
          </Button>
        </li>
      )}
      <li>
        <Button onClick={() => onTake("alone")}>
          Alone <span class={shapeCss["solid-fate"]}>all {count} leave</span>
        </Button>
      </li>
      <li>
        <Button kind="quiet" onClick={onBack}>
          Back to the shapes
        </Button>
      </li>
    </ul>
  );
}

const WORDS: Record<How | "ask", string> = {
  ask: "Choose a shape first: what becomes of the objects here is asked then.",
  alone: "A new beginning: all that was there leaves, and Undo brings it back.",
  instead: "It takes the place of the chosen object, moved and coloured as that is.",
  beside: "It stands beside what there is.",
};
