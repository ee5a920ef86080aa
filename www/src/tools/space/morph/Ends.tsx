import { useEffect, useMemo, useState } from "preact/hooks";
import { announce, notify, wordsOf } from "#document/notice";
import { changeSpace } from "#document/space/edits";
import { choose, editSpace, space } from "#document/space/space";
import { Dialog } from "#ui/overlay/Dialog";
import { EndCard, SwapEnds } from "#ui/shapes/EndCard";
import endsCss from "#ui/shapes/ends.module.css";
import { mapsNote, ShapeGrid } from "#ui/shapes/ShapeGrid";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import type { Shape3 } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "../messages";
import { Gallery } from "../shape/object/Gallery";
import { presets } from "../shape/object/presets";
import { makePictures, pictures } from "../shape/object/thumbs";
import { type Goal, goalsOf, missingWords } from "./goals";
import { leadingTo, swapped } from "./morph-edits";
import morph3Css from "./morph3.module.css";

/** The two ends of the morph, with the arrow that swaps them. */
export function Ends() {
  const [open, setOpen] = useState<"a" | "b" | null>(null);
  const a = space.value?.objects[0];
  const b = space.value?.morph?.to;
  const { name = "", maps } = a ?? {};
  const goal = b?.maps;
  const goalName = b?.name ?? "";
  useEffect(() => {
    const subjects = [
      ...(maps ? [{ id: "morph-a", objects: [{ name, maps }] }] : []),
      ...(goal ? [{ id: "morph-b", objects: [{ name: goalName, maps: goal }] }] : []),
    ];
    return makePictures(subjects);
  }, [name, maps, goalName, goal]);
  if (!a) return null;
  return (
    <section class={endsCss["ends"]} aria-label={messages.twoShapes}>
      <Card
        end="a"
        shape={a}
        onOpen={() => {
          choose(0);
          setOpen("a");
        }}
      />
      <SwapEnds
        disabled={!b || b.maps.length !== a.maps.length}
        onSwap={() => {
          changeSpace(swapped);
          const now = space.peek();
          announce(messages.swapped(now?.objects[0]?.name ?? "", now?.morph?.to.name ?? ""));
        }}
      />
      {b ? (
        <Card end="b" shape={b} onOpen={() => setOpen("b")} />
      ) : (
        <button
          type="button"
          class={`${endsCss["card"]} ${morph3Css["morph3-empty"]}`}
          aria-haspopup="dialog"
          onClick={() => setOpen("b")}
        >
          <span class={endsCss["card-end"]} aria-hidden="true">
            B
          </span>
          <span>{messages.chooseShape}</span>
        </button>
      )}
      {open === "a" && <Gallery how="instead" onClose={() => setOpen(null)} />}
      {open === "b" && <Goals onClose={() => setOpen(null)} />}
    </section>
  );
}

function Card({ end, shape, onOpen }: { end: "a" | "b"; shape: Shape3; onOpen: () => void }) {
  const note = `${mapsNote(shape)}${shape.preset === undefined ? messages.custom2 : ""}`;
  return (
    <EndCard
      end={end}
      name={shape.name}
      note={note}
      count={note}
      picture={<Thumbnail bitmap={pictures.value.get(`morph-${end}`)} />}
      onChoose={onOpen}
    />
  );
}

/** Everything that the first object can become. */
function Goals({ onClose }: { onClose: () => void }) {
  const objects = space.value?.objects;
  const goals = useMemo(() => goalsOf(objects ?? [], presets()), [objects]);
  useEffect(() => makePictures(goals.map(({ id, shape }) => ({ id, objects: [shape] }))), [goals]);
  const first = objects?.[0];
  if (!first) return null;
  const now = space.value?.morph?.to;
  return (
    <Dialog
      wide
      title={messages.shapeB}
      about={missingWords(first.maps.length, presets(), first.name)}
      onClose={onClose}
    >
      <ShapeGrid
        presets={goals}
        pictures={pictures.value}
        noteOf={({ shape }: Goal) => mapsNote(shape)}
        chosen={now?.preset}
        onChoose={(goal) => {
          lead(goal.shape);
          onClose();
        }}
      />
    </Dialog>
  );
}

/** Leads the first object there, each map to the one that is nearest. */
export function lead(to: Shape3): void {
  try {
    editSpace((now) => {
      const from = now.objects[0]?.maps ?? [];
      return leadingTo(now, to, solid.correspondence3(from, to.maps));
    });
    choose(0);
    announce(messages.firstBecomes(to.name));
  } catch (problem) {
    notify({ kind: "error", text: wordsOf(problem) });
  }
}
