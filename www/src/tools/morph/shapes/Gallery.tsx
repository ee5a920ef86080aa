import { PresetGallery } from "#curve/PresetGallery";
import { DirectedShelf } from "#directed/Shelf";
import { editSystems } from "#document/curve/systems";
import { chooseSystem } from "#document/directed/edits";
import { selection } from "#document/morph";
import { announce } from "#document/notice";
import { originOf } from "#document/presets";
import { standIn } from "#document/stand-in";
import { choose, nameOf, other } from "../changes";
import { gallery } from "../dialogs";
import { pick } from "../locus/path/way";
import { shapes } from "../parts";
import { bondWords, partnersOf } from "./partners";

/** Every preset, to be the shape of one end, and the closed curves. */
export function Gallery() {
  const end = gallery.value;
  if (end === null) return null;
  const close = () => {
    gallery.value = null;
  };
  const beside = shapes[other(end)].value;
  const partners = partnersOf(originOf(beside)?.id ?? "");
  return (
    <PresetGallery
      title={`Shape ${nameOf(end)}`}
      about="Each is made of smaller copies of itself. Its maps can be edited afterwards."
      end={end}
      now={shapes[end].value}
      markOf={({ id }) => {
        const bond = partners.get(id);
        return bond ? bondWords(bond, beside.name) : null;
      }}
      onChoose={(shape) => {
        if (standIn.peek() === "directed") chooseSystem(end, shape);
        else void editSystems((before) => choose(before, end, shape));
        if (selection.peek()?.target === end) selection.value = { target: end, map: 0 };
        pick(null);
        announce(`Shape ${nameOf(end)} is now ${shape.name}.`);
      }}
      onClose={close}
      more={<DirectedShelf end={end} onChosen={close} />}
    />
  );
}
