import { thumbnails } from "#compute/results";
import { Shelf } from "#curve/parts";
import { curved } from "#document/curve/curve";
import { editSystems } from "#document/curve/systems";
import { selection } from "#document/morph";
import { announce } from "#document/notice";
import { originOf, presets } from "#document/presets";
import { Dialog } from "#ui/overlay/Dialog";
import { mapsNote, ShapeGrid } from "#ui/shapes/ShapeGrid";
import { choose, nameOf } from "../changes";
import { gallery } from "../dialogs";
import { pick } from "../locus/path/way";
import { shapes } from "../parts";

/** Every preset, to be the shape of one end, and the closed curves. */
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
        noteOf={mapsNote}
        chosen={curved.value ? undefined : originOf(shapes[end].value)?.id}
        onChoose={(preset) => {
          void editSystems((before) => choose(before, end, preset));
          if (selection.peek()?.target === end) selection.value = { target: end, map: 0 };
          pick(null);
          announce(`Shape ${nameOf(end)} is now ${preset.name}.`);
          close();
        }}
      />
      <Shelf end={end} onChosen={close} />
    </Dialog>
  );
}
