import { PresetGallery } from "#curve/PresetGallery";
import { editSystems } from "#document/curve/systems";
import { selection } from "#document/morph";
import { announce } from "#document/notice";
import { choose, nameOf } from "../changes";
import { gallery } from "../dialogs";
import { pick } from "../locus/path/way";
import { shapes } from "../parts";

/** Every preset, to be the shape of one end, and the closed curves. */
export function Gallery() {
  const end = gallery.value;
  if (end === null) return null;
  return (
    <PresetGallery
      title={`Shape ${nameOf(end)}`}
      about="Each is made of smaller copies of itself. Its maps can be edited afterwards."
      end={end}
      now={shapes[end].value}
      onChoose={(shape) => {
        void editSystems((before) => choose(before, end, shape));
        if (selection.peek()?.target === end) selection.value = { target: end, map: 0 };
        pick(null);
        announce(`Shape ${nameOf(end)} is now ${shape.name}.`);
      }}
      onClose={() => {
        gallery.value = null;
      }}
    />
  );
}
