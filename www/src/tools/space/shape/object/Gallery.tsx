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
import * as messages from "../messages";
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
      name: messages.naturalScene,
      about: messages.hillsTreesWithBark,
      objects: natural.objects,
      look: natural,
    },
    {
      id: PLANE,
      name: messages.fromPlane(name),
      about: messages.shapeMorphToolAs,
      objects: [{ name, maps: solid.lift(standing.peek()) }],
    },
  ];
}

function note({ objects }: Item): string {
  const [first] = objects;
  return objects.length > 1 || !first ? messages.objectCount(objects.length) : mapsNote(first);
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
      title={asked ? messages.whereTo(asked.name) : messages.shapesInSpace}
      about={asked ? messages.nothingHasChangedYet : messages.eachNothingButHandful}
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
            label={messages.placeAs}
            value={how}
            onChange={setHow}
            options={[
              {
                value: "alone",
                label: messages.newScene,
                description: messages.startsOverWithWithout,
              },
              { value: "instead", label: several ? messages.insteadOf(now?.name ?? "") : messages.replace },
              { value: "beside", label: messages.add },
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
          {messages.add} <span class={shapeCss["solid-fate"]}>{messages.allStay(count)}</span>
        </Button>
      </li>
      {item.objects.length === 1 && (
        <li>
          <Button onClick={() => onTake("instead")}>
            {messages.replaceWhat(instead)}{" "}
            <span class={shapeCss["solid-fate"]}>{messages.oneLeaves(instead)}</span>
          </Button>
        </li>
      )}
      <li>
        <Button onClick={() => onTake("alone")}>
          {messages.newScene} <span class={shapeCss["solid-fate"]}>{messages.allLeave(count)}</span>
        </Button>
      </li>
      <li>
        <Button kind="quiet" onClick={onBack}>
          {messages.backToShapes}
        </Button>
      </li>
    </ul>
  );
}

const WORDS: Record<How | "ask", string> = {
  ask: messages.firstChooseShapeThen,
  alone: messages.newSceneAllObjects,
  instead: messages.replacesSelectedObjectWith,
  beside: messages.addedToScene,
};
