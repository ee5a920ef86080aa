import { PresetGallery } from "#curve/PresetGallery";
import { DirectedShelf } from "#directed/Shelf";
import { tellReplaced } from "#document/curve/replaced";
import { editSystems } from "#document/curve/systems";
import { systemOf } from "#document/directed/changes";
import { chooseDirected, chooseSystem } from "#document/directed/edits";
import { beginChoice } from "#document/editing/choice";
import { setFrame } from "#document/editing/frame";
import { selection } from "#document/morph";
import { announce } from "#document/notice";
import { presets } from "#document/presets";
import { scene } from "#document/scene";
import { standIn } from "#document/stand-in";
import type { Shape } from "#wasm/api";
import { editMaps, gallery } from "../dialogs";
import { shapes } from "../document-signals";
import { choose, nameOf, other } from "../edits";
import { pick } from "../locus/path/waypoints";
import * as messages from "../messages";
import { BLANK_FRAME, blankShape, NewShape } from "./NewShape";
import { bondWords, partnersOf } from "./partners";
import { promise } from "./promised";

/** The system at an end, if there is one: what takes part in the morph, and not what it stands in for. */
function besideOf(end: "a" | "b"): Shape | null {
  const { directed } = scene.value;
  if (directed) return systemOf(directed[end]);
  return standIn.value ? null : shapes[end].value;
}

/** Which shape of the gallery has these maps. */
const idOf = ({ preset, maps }: Shape): string =>
  preset ?? presets().find((one) => JSON.stringify(one.maps) === JSON.stringify(maps))?.id ?? "";

/** Every preset, to be the shape of one end, and the closed curves. */
export function Gallery() {
  const end = gallery.value;
  if (end === null) return null;
  const close = () => {
    gallery.value = null;
  };
  const beside = besideOf(other(end));
  const partners = partnersOf(beside ? idOf(beside) : "");
  const { curves, [other(end)]: system } = scene.value;
  const outline = curves?.[other(end)].name;
  const take = async (shape: Shape) => {
    const before = scene.peek();
    if (standIn.peek() === "directed") chooseSystem(end, shape);
    else {
      await editSystems((now) => choose(now, end, shape));
      tellReplaced(before, end);
      promise(scene.peek(), partners.get(shape.preset ?? "") === "other");
    }
    if (selection.peek()?.target === end) selection.value = { target: end, map: 0 };
    pick(null);
    announce(messages.shapeNow(nameOf(end), shape.name));
  };
  return (
    <PresetGallery
      title={messages.shape(nameOf(end))}
      about={
        outline === undefined
          ? messages.eachMadeSmallerCopies
          : messages.otherIsOutline(nameOf(other(end)), outline)
      }
      apart={
        outline === undefined ? null : messages.replacesOutline(nameOf(other(end)), system.name, outline)
      }
      end={end}
      now={shapes[end].value}
      markOf={({ id }) => {
        const bond = partners.get(id);
        return bond && beside ? bondWords(bond, beside.name) : null;
      }}
      onChoose={(shape) => void take(shape)}
      onDirected={(shape) => {
        const before = scene.peek();
        selection.value = null;
        chooseDirected(end, shape);
        tellReplaced(before, end);
        pick(null);
        announce(messages.shapeNow(nameOf(end), shape.name));
      }}
      onClose={close}
      first={
        <NewShape
          onChoose={(count) => {
            beginChoice();
            close();
            const shape = blankShape(count);
            setFrame(shape.maps, BLANK_FRAME);
            void take(shape).then(() => {
              if (!standIn.peek()) editMaps(end);
            });
          }}
        />
      }
      more={<DirectedShelf end={end} onChosen={close} />}
    />
  );
}
