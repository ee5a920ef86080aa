import { useEffect, useState } from "preact/hooks";
import { thumbnails } from "#compute/results";
import { thumbnailsOf } from "#compute/thumbnails";
import { DirectedThumb } from "#directed/Thumb";
import { sizeWords } from "#directed/words";
import { beginChoice } from "#document/editing/choice";
import { announce, notify, wordsOf } from "#document/notice";
import { LONGEST_NAME, type OwnShape, ownShapes, removeOwnShape, renameOwnShape } from "#document/own-shapes";
import { withExact } from "#geometry/maps/exact";
import { withWeights } from "#geometry/maps/weighted";
import { IconButton } from "#ui/controls/Button";
import { NameInput } from "#ui/shapes/NameInput";
import { mapsNote } from "#ui/shapes/ShapeGrid";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import type { DirectedShape, Shape } from "#wasm/api";
import { frond } from "#wasm/core";
import * as messages from "./messages";
import css from "./own-shapes.module.css";

const pictureOf = (id: string) => `own-${id}`;

interface OwnShapesProps {
  onChoose: (shape: Shape) => void;
  /** Where shapes of several states can be chosen, too. */
  onDirected?: (shape: DirectedShape) => void;
  /** Two in the width of a panel. */
  small?: boolean;
}

/** The shapes that a person keeps, to choose one from, to rename and to remove. Nothing where there are none. */
export function OwnShapes({ onChoose, onDirected, small = false }: OwnShapesProps) {
  const all = ownShapes.value;
  const shapes = onDirected ? all : all.filter(({ states }) => !states);
  // biome-ignore lint/correctness/useExhaustiveDependencies: a signal: other shapes are to have their pictures.
  useEffect(() => {
    const plain = all.filter(({ states }) => !states);
    return thumbnailsOf(plain.map(({ id, maps }) => ({ id: pictureOf(id), maps })));
  }, [all]);
  if (shapes.length === 0) return null;
  return (
    <section class={css["own-shapes"]} aria-label={messages.yourShapes}>
      <h3>{messages.yours}</h3>
      <ul class={`${css["list"]} ${small ? css["own-narrow"] : ""}`}>
        {shapes.map((shape) => (
          <Item key={shape.id} shape={shape} onChoose={onChoose} onDirected={onDirected} />
        ))}
      </ul>
    </section>
  );
}

interface ItemProps {
  shape: OwnShape;
  onChoose: (shape: Shape) => void;
  onDirected: ((shape: DirectedShape) => void) | undefined;
}

function Item({ shape, onChoose, onDirected }: ItemProps) {
  const { id, name, maps, weights, exact, states, outline } = shape;
  const note = states ? sizeWords({ states }) : mapsNote(shape);
  const [naming, setNaming] = useState(false);
  const tell = (problem: string | null, done: string) =>
    problem === null ? announce(done) : notify({ kind: "info", text: problem });
  const take = () => {
    beginChoice();
    if (states) {
      onDirected?.({ name, states, ...(outline === undefined ? {} : { outline }) });
      return;
    }
    try {
      frond.validate({ maps });
      onChoose(withWeights(withExact({ name, maps }, exact), weights));
    } catch (problem) {
      notify({ kind: "info", text: messages.cannotUse(name, wordsOf(problem)) });
    }
  };
  return (
    <li class={css["item"]}>
      <button type="button" class={css["face"]} aria-label={`${name}, ${note}`} onClick={take}>
        {states ? (
          <DirectedThumb states={states} />
        ) : (
          <Thumbnail bitmap={thumbnails.value.get(pictureOf(id))} />
        )}
        {!naming && <span class={css["own-name"]}>{name}</span>}
      </button>
      {naming && (
        <NameInput
          label={messages.nameOf(name)}
          name={name}
          longest={LONGEST_NAME}
          focused
          onName={(given) => tell(renameOwnShape(id, given), messages.renamedTo(given))}
          onEnd={() => setNaming(false)}
        />
      )}
      <span class={css["own-tools"]}>
        <small>{note}</small>
        <IconButton icon="edit" kind="quiet" label={messages.rename(name)} onClick={() => setNaming(true)} />
        <IconButton
          icon="bin"
          kind="quiet"
          label={messages.remove(name)}
          onClick={() => tell(removeOwnShape(id), messages.wasRemoved(name))}
        />
      </span>
    </li>
  );
}
