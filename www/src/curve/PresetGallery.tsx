import type { ComponentChildren } from "preact";
import { thumbnails } from "#compute/results";
import { originOf, presets } from "#document/presets";
import { standIn } from "#document/stand-in";
import { Dialog } from "#ui/overlay/Dialog";
import { CARDS } from "#ui/shapes/EndCard";
import { mapsNote, ShapeGrid } from "#ui/shapes/ShapeGrid";
import type { DirectedShape, Preset, Shape } from "#wasm/api";
import * as messages from "./messages";
import { OwnShapes } from "./OwnShapes";
import css from "./own-shapes.module.css";
import { Shelf } from "./parts";

interface PresetGalleryProps {
  title: string;
  about: string;
  /** What is chosen for, with the shape that it has now. */
  end: "a" | "b" | "bent";
  now: Shape;
  /** What is good about a shape. */
  markOf?: (preset: Preset) => string | null;
  onChoose: (shape: Shape) => void;
  /** Where shapes of several states can be chosen, too. */
  onDirected?: (shape: DirectedShape) => void;
  onClose: () => void;
  /** Why shapes of maps do not go with what is there: then outlines come first. */
  apart?: string | null;
  /** What comes first. */
  first?: ComponentChildren;
  /** What else there is to choose. */
  more?: ComponentChildren;
}

/** The shapes that a person keeps, every preset, and the closed curves, to choose one from. */
export function PresetGallery({
  title,
  about,
  end,
  now,
  markOf,
  onChoose,
  onDirected,
  onClose,
  apart = null,
  first,
  more,
}: PresetGalleryProps) {
  const take = (shape: Shape) => {
    onChoose(shape);
    onClose();
  };
  const outlines = <Shelf end={end} onChosen={onClose} />;
  return (
    <Dialog
      wide
      title={title}
      about={about}
      onClose={onClose}
      back={() => (end === "bent" ? null : CARDS[end].current)}
    >
      {apart === null && first}
      {apart !== null && (
        <>
          {outlines}
          <h3 class={css["maps-heading"]}>{messages.shapesMaps}</h3>
          <p class="hint">{apart}</p>
          {first}
        </>
      )}
      <OwnShapes
        onChoose={take}
        {...(onDirected
          ? {
              onDirected: (shape) => {
                onDirected(shape);
                onClose();
              },
            }
          : {})}
      />
      <ShapeGrid
        presets={presets()}
        pictures={thumbnails.value}
        noteOf={mapsNote}
        markOf={markOf}
        dim={apart !== null}
        chosen={standIn.value ? undefined : originOf(now)?.id}
        onChoose={({ id, name, maps }) => take({ preset: id, name, maps })}
      />
      {apart === null && outlines}
      {more}
    </Dialog>
  );
}
