import { originOf, presets } from "../../../engine/presets";
import { thumbnails } from "../../../engine/results";
import { selection } from "../../../state/morph";
import { announce } from "../../../state/notice";
import { edit } from "../../../state/scene";
import { Dialog } from "../../../ui/Dialog";
import { ShapeGrid } from "../../../ui/ShapeGrid";
import { choose, nameOf } from "../changes";
import { gallery } from "../dialogs";
import { pick } from "../locus/way";
import { shapes } from "../parts";

/** Every preset, to be the shape of one end. */
export function Gallery() {
  const end = gallery.value;
  if (end === null) return null;
  const close = () => {
    gallery.value = null;
  };
  return (
    <Dialog
      wide
      title={`Shape ${nameOf(end)}`}
      about="Each is made of smaller copies of itself. Its maps can be edited afterwards."
      onClose={close}
    >
      <ShapeGrid
        presets={presets()}
        pictures={thumbnails.value}
        chosen={originOf(shapes[end].value)?.id}
        onChoose={(preset) => {
          edit((before) => choose(before, end, preset));
          if (selection.peek()?.target === end) selection.value = { target: end, map: 0 };
          pick(null);
          announce(`Shape ${nameOf(end)} is now ${preset.name}.`);
          close();
        }}
      />
    </Dialog>
  );
}
