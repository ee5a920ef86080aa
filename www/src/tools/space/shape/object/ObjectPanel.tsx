import { useEffect, useRef, useState } from "preact/hooks";
import { announce } from "#document/notice";
import { endGesture } from "#document/scene";
import { changeSpace, reshapeSpace } from "#document/space/edits";
import { choose, chosen, space } from "#document/space/space";
import { Button, IconButton } from "#ui/controls/Button";
import { useOwnId } from "#ui/id";
import { Dialog } from "#ui/overlay/Dialog";
import { mapsNote } from "#ui/shapes/ShapeGrid";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import { MOST_OBJECTS, withoutObject, withTint } from "../changes";
import { object } from "../now";
import { leftOut, opened, openFile, saveFile, takeFound } from "./files";
import { Gallery } from "./Gallery";
import { Swatch } from "./Swatch";
import type { How } from "./take";
import { makePictures, pictures } from "./thumbs";

/** What there is: the objects, the one that all else is about, and where others come from. */
export function ObjectPanel() {
  const [gallery, setGallery] = useState<How | "ask" | null>(null);
  const input = useRef<HTMLInputElement>(null);
  const now = object.value;
  const count = space.value?.objects.length ?? 0;
  const { name = "", maps } = now ?? {};
  // Its own, whatever else is in space: as made, so that it stays while the object moves.
  useEffect(
    () => (maps ? makePictures([{ id: "chosen", objects: [{ name, maps }] }]) : undefined),
    [name, maps],
  );
  return (
    <section class="solid-part" aria-label="Objects">
      <button
        type="button"
        class="solid-subject"
        aria-haspopup="dialog"
        aria-label={`${now?.name}. Choose another shape`}
        title="Choose another shape"
        onClick={() => setGallery(count > 1 ? "ask" : "alone")}
      >
        <Thumbnail bitmap={pictures.value.get("chosen")} />
        <span class="solid-subject-name">{now?.name}</span>
        <span class="solid-subject-about">
          {now && mapsNote(now)}
          {now?.preset === undefined ? ", its own" : ""}
        </span>
      </button>
      {count > 1 && <ObjectList />}
      <div class="solid-buttons">
        <Button
          icon="add"
          popup="dialog"
          description="Put another object beside what there is"
          disabled={count >= MOST_OBJECTS}
          onClick={() => setGallery("beside")}
        >
          Add
        </Button>
        <Button kind="quiet" onClick={() => input.current?.click()}>
          Open .ifs…
        </Button>
        <Button
          kind="quiet"
          icon="save"
          description="The parameters as they are now, for Fractint and for Frond"
          onClick={saveFile}
        >
          Save .ifs
        </Button>
      </div>
      <input
        ref={input}
        type="file"
        accept=".ifs,.txt,text/plain"
        hidden
        onChange={(event) => {
          const file = event.currentTarget.files?.[0];
          if (file) void openFile(file);
          // The same file once more is a change, too.
          event.currentTarget.value = "";
        }}
      />
      {gallery && <Gallery how={gallery} onClose={() => setGallery(null)} />}
      {opened.value && <Systems />}
    </section>
  );
}

function ObjectList() {
  const name = useOwnId("object");
  const objects = space.value?.objects ?? [];
  const at = chosen.value;
  return (
    <div class="solid-objects" role="radiogroup" aria-label="The object that is worked on">
      {objects.map((one, index) => (
        <div key={index} class="solid-object">
          <label>
            <input
              type="radio"
              name={name}
              value={index}
              checked={index === at}
              onChange={() => choose(index)}
            />
            <Swatch map={index} tint={one.tint ?? "conic-gradient(#e69f00, #56b4e9, #009e73, #e69f00)"} />
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
        class="solid-tint"
        aria-label={`One colour for all of ${name}`}
        title="One colour for all of it"
        value={tint ?? "#808080"}
        onInput={(event) => {
          const { value } = event.currentTarget;
          changeSpace((now) => withTint(now, index, value), { gesture: `tint ${index}` });
        }}
        onChange={endGesture}
      />
      {tint !== undefined && (
        <IconButton
          icon="reset"
          label="Let its maps have their colours"
          kind="quiet"
          onClick={() => changeSpace((now) => withTint(now, index, null))}
        />
      )}
      <IconButton
        icon="bin"
        label={`Remove ${name}`}
        kind="quiet"
        onClick={() => {
          if (reshapeSpace((now) => withoutObject(now, index))) announce(`${name} is removed.`);
        }}
      />
    </>
  );
}

/** The systems of a file with several. */
function Systems() {
  const { file, systems, flat } = opened.value ?? { file: "", systems: [], flat: 0 };
  const close = () => {
    opened.value = null;
  };
  return (
    <Dialog
      title={file}
      about={`${systems.length} systems of space are in it. Which one shall it be? ${leftOut(flat)}`}
      onClose={close}
    >
      <ul class="solid-systems">
        {systems.map((system, i) => (
          <li key={i}>
            <Button
              onClick={() => {
                takeFound(system);
                close();
              }}
            >
              {system.name} <span class="dim">{mapsNote(system)}</span>
            </Button>
          </li>
        ))}
      </ul>
    </Dialog>
  );
}
