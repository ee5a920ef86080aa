import { useRef, useState } from "preact/hooks";
import type { Preset } from "../../../engine/api";
import { thumbnails } from "../../../engine/results";
import { selection } from "../../../state/morph";
import { announce } from "../../../state/notice";
import { edit } from "../../../state/scene";
import { Dialog } from "../../../ui/Dialog";
import { choose, nameOf } from "../changes";
import { gallery } from "../dialogs";
import { pick } from "../locus/way";
import { shapes } from "../parts";
import { originOf, presets } from "../presets";
import { Thumbnail } from "./Thumbnail";

/** Every preset, with its picture and one sentence; arrows walk the grid. */
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
      <Grid
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

function Grid({ chosen, onChoose }: { chosen: string | undefined; onChoose: (preset: Preset) => void }) {
  const all = presets();
  const [active, setActive] = useState(() =>
    Math.max(
      0,
      all.findIndex((preset) => preset.id === chosen),
    ),
  );
  const list = useRef<HTMLUListElement>(null);

  const walk = (event: KeyboardEvent) => {
    const items = [...(list.current?.querySelectorAll<HTMLButtonElement>("button") ?? [])];
    // The style sheet decides how many are in a row: count those at the height of the first.
    const top = items[0]?.offsetTop ?? 0;
    const across = Math.max(1, items.filter((item) => item.offsetTop === top).length);
    const by = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: across, ArrowUp: -across }[event.key];
    const to =
      event.key === "Home" ? 0 : event.key === "End" ? items.length - 1 : by === undefined ? -1 : active + by;
    if (to < 0 || to >= items.length) return;
    event.preventDefault();
    setActive(to);
    items[to]?.focus();
  };

  return (
    <ul class="gallery" ref={list} onKeyDown={walk}>
      {all.map((preset, index) => (
        <li key={preset.id}>
          <button
            type="button"
            class="gallery-item"
            tabIndex={index === active ? 0 : -1}
            autofocus={index === active}
            aria-current={preset.id === chosen ? "true" : undefined}
            onFocus={() => setActive(index)}
            onClick={() => onChoose(preset)}
          >
            <Thumbnail bitmap={thumbnails.value.get(preset.id)} />
            <span class="gallery-name">
              {preset.name}
              <small>
                {preset.maps.length} {preset.maps.length === 1 ? "map" : "maps"}
              </small>
            </span>
            <span class="gallery-about">{preset.about}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}
