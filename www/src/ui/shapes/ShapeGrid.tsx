import { useRef, useState } from "preact/hooks";
import { beginChoice } from "#document/editing/choice";
import { placeTyped } from "../type-ahead";
import css from "./shape-grid.module.css";
import { Thumbnail } from "./Thumbnail";

/** A shape to choose. */
export interface ShapeItem {
  id: string;
  name: string;
  /** One sentence. */
  about: string;
}

interface ShapeGridProps<T extends ShapeItem> {
  presets: readonly T[];
  /** What stands beside the name. */
  noteOf: (preset: T) => string;
  /** What is good about it, on a line of its own. */
  markOf?: ((preset: T) => string | null) | undefined;
  /** By preset id. */
  pictures: ReadonlyMap<string, ImageBitmap>;
  /** The id of the one that is there now. */
  chosen: string | undefined;
  onChoose: (preset: T) => void;
  /** Their pictures are faint: they do not go with what is there. */
  dim?: boolean;
}

/** How many maps a system has. */
export function mapsNote({ maps }: { maps: readonly unknown[] }): string {
  return `${maps.length} ${maps.length === 1 ? "map" : "maps"}`;
}

/** Letters within this time of each other are of one name. */
const TYPING_MS = 900;

/** Every preset, with its picture and one sentence; arrows walk the grid. */
export function ShapeGrid<T extends ShapeItem>(props: ShapeGridProps<T>) {
  const { presets: all, pictures, chosen, noteOf, markOf, onChoose, dim = false } = props;
  const [active, setActive] = useState(() =>
    Math.max(
      0,
      all.findIndex((preset) => preset.id === chosen),
    ),
  );
  const list = useRef<HTMLUListElement>(null);

  const typed = useRef({ text: "", at: 0 });
  /** The place of the name that is typed, letter by letter; null where the key types nothing. */
  const typing = ({ key, ctrlKey, metaKey, altKey, timeStamp }: KeyboardEvent): number | null => {
    if (key.length !== 1 || key === " " || ctrlKey || metaKey || altKey) return null;
    const { text, at } = typed.current;
    typed.current = { text: timeStamp - at < TYPING_MS ? text + key : key, at: timeStamp };
    return placeTyped(
      all.map(({ name }) => name),
      active,
      typed.current.text,
    );
  };
  const walk = (event: KeyboardEvent) => {
    const items = [...(list.current?.querySelectorAll<HTMLButtonElement>("button") ?? [])];
    // The style sheet decides how many are in a row: count those at the height of the first.
    const top = items[0]?.offsetTop ?? 0;
    const across = Math.max(1, items.filter((item) => item.offsetTop === top).length);
    const by = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: across, ArrowUp: -across }[event.key];
    const named = typing(event);
    const to =
      named ??
      (event.key === "Home"
        ? 0
        : event.key === "End"
          ? items.length - 1
          : by === undefined
            ? -1
            : active + by);
    if (to < 0 || to >= items.length) return;
    event.preventDefault();
    setActive(to);
    items[to]?.focus();
  };

  return (
    <ul class={`${css["gallery"]} ${dim ? css["dim"] : ""}`} ref={list} onKeyDown={walk}>
      {all.map((preset, index) => (
        <li key={preset.id}>
          <button
            type="button"
            class={css["gallery-item"]}
            tabIndex={index === active ? 0 : -1}
            autofocus={index === active}
            aria-current={preset.id === chosen ? "true" : undefined}
            onFocus={() => setActive(index)}
            onClick={() => {
              beginChoice();
              onChoose(preset);
            }}
          >
            <Thumbnail bitmap={pictures.get(preset.id)} />
            <span class={css["gallery-name"]}>
              <span translate={false}>{preset.name}</span>
              <small>{noteOf(preset)}</small>
            </span>
            <span class={css["gallery-about"]}>{preset.about}</span>
            {markOf?.(preset) && <span class={css["gallery-mark"]}>{markOf(preset)}</span>}
          </button>
        </li>
      ))}
    </ul>
  );
}
