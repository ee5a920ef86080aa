import { useEffect, useState } from "preact/hooks";
import { announce } from "#document/notice";
import { dark } from "#document/preferences";
import { endGesture } from "#document/scene";
import { changeSpace, reshapeSpace } from "#document/space/edits";
import { choose, chosen, space } from "#document/space/space";
import { GREY } from "#style/colours";
import { palette } from "#style/palette";
import { Button, IconButton } from "#ui/controls/Button";
import { askForFile } from "#ui/files/door";
import { useOwnId } from "#ui/id";
import { mapsNote } from "#ui/shapes/ShapeGrid";
import { SubjectCard } from "#ui/shapes/SubjectCard";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import * as messages from "../messages";
import { object } from "../now";
import { MOST_OBJECTS, withoutObject, withTint } from "../object-edits";
import shapeCss from "../shape.module.css";
import { saveFile } from "./files";
import { Gallery } from "./Gallery";
import type { How } from "./take";
import { makePictures, pictures } from "./thumbs";

/** What there is: the objects, the one that all else is about, and where others come from. */
export function ObjectPanel() {
  const [gallery, setGallery] = useState<How | "ask" | null>(null);
  const now = object.value;
  const count = space.value?.objects.length ?? 0;
  const { name = "", maps } = now ?? {};
  // Its own, whatever else is in space: as made, so that it stays while the object moves.
  useEffect(
    () => (maps ? makePictures([{ id: "chosen", objects: [{ name, maps }] }]) : undefined),
    [name, maps],
  );
  return (
    <section class="stack" aria-label={messages.objects}>
      <SubjectCard
        picture={<Thumbnail bitmap={pictures.value.get("chosen")} />}
        name={now?.name}
        about={
          <>
            {now && mapsNote(now)}
            {now?.preset === undefined ? messages.custom2 : ""}
          </>
        }
        label={messages.chooseAnother(now?.name ?? "")}
        onChoose={() => setGallery(count > 1 ? "ask" : "alone")}
      />
      {count > 1 && <ObjectList />}
      <div class={shapeCss["solid-buttons"]}>
        <Button
          icon="add"
          popup="dialog"
          description={messages.addAnotherObjectTo}
          disabled={count >= MOST_OBJECTS}
          onClick={() => setGallery("beside")}
        >
          {messages.add}
        </Button>
        <Button kind="quiet" description={messages.mapsSpaceFromFractint} onClick={() => askForFile()}>
          {messages.openIfs}
        </Button>
        <Button
          kind="quiet"
          icon="save"
          description={messages.currentParametersForFractint}
          onClick={saveFile}
        >
          {messages.saveIfs}
        </Button>
      </div>
      {gallery && <Gallery how={gallery} onClose={() => setGallery(null)} />}
    </section>
  );
}

function ObjectList() {
  const name = useOwnId("object");
  const objects = space.value?.objects ?? [];
  const at = chosen.value;
  return (
    <div class={shapeCss["solid-objects"]} role="radiogroup" aria-label={messages.selectedObject}>
      {objects.map((one, index) => (
        <div key={index} class={shapeCss["solid-object"]}>
          <label>
            <input
              type="radio"
              name={name}
              value={index}
              checked={index === at}
              onChange={() => choose(index)}
            />
            <Swatch
              map={index}
              tint={one.tint ?? "conic-gradient(var(--orange), var(--sky), var(--green), var(--orange))"}
            />
            <span>{one.name}</span>
          </label>
          {index === at && <ObjectTools index={index} tint={one.tint} name={one.name} />}
        </div>
      ))}
    </div>
  );
}

function ObjectTools({ index, tint, name }: { index: number; tint: string | undefined; name: string }) {
  return (
    <>
      <input
        type="color"
        class={shapeCss["solid-tint"]}
        aria-label={messages.oneColourFor(name)}
        title={messages.oneColourForWhole}
        value={tint ?? GREY}
        onInput={(event) => {
          const { value } = event.currentTarget;
          changeSpace((now) => withTint(now, index, value), { gesture: `tint ${index}` });
        }}
        onChange={endGesture}
      />
      {tint !== undefined && (
        <IconButton
          icon="reset"
          label={messages.useColoursMaps}
          kind="quiet"
          onClick={() => changeSpace((now) => withTint(now, index, null))}
        />
      )}
      <IconButton
        icon="bin"
        label={messages.remove(name)}
        kind="quiet"
        onClick={() => {
          if (reshapeSpace((now) => withoutObject(now, index))) announce(messages.isRemoved(name));
        }}
      />
    </>
  );
}

/** The systems of a file with several. */

/** The number of a map or an object in its colour. */
export function Swatch({ map, tint }: { map: number; tint?: string | undefined }) {
  const colours = palette(dark.value ? "dark" : "light");
  return (
    <span
      class={shapeCss["solid-swatch"]}
      aria-hidden="true"
      style={{ background: tint ?? colours[map % colours.length] ?? "gray" }}
    />
  );
}
