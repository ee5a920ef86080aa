import { thumbnails } from "#compute/results";
import { curved } from "#document/curve/curve";
import { originOf, presets } from "#document/presets";
import { Dialog } from "#ui/overlay/Dialog";
import { mapsNote, ShapeGrid } from "#ui/shapes/ShapeGrid";
import type { Preset, Shape } from "#wasm/api";
import { Shelf } from "./parts";

interface PresetGalleryProps {
  title: string;
  about: string;
  /** What is chosen for, with the shape that it has now. */
  end: "a" | "b" | "bent";
  now: Shape;
  onChoose: (preset: Preset) => void;
  onClose: () => void;
}

/** Every preset, and the closed curves, to choose one from. */
export function PresetGallery({ title, about, end, now, onChoose, onClose }: PresetGalleryProps) {
  return (
    <Dialog wide title={title} about={about} onClose={onClose}>
      <ShapeGrid
        presets={presets()}
        pictures={thumbnails.value}
        noteOf={mapsNote}
        chosen={curved.value ? undefined : originOf(now)?.id}
        onChoose={(preset) => {
          onChoose(preset);
          onClose();
        }}
      />
      <Shelf end={end} onChosen={onClose} />
    </Dialog>
  );
}
