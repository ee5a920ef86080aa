import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { IconButton } from "../controls/Button";
import * as messages from "../messages";
import css from "./map-list.module.css";

interface MapListProps {
  /** Each map at a glance. */
  maps: readonly string[];
  /** Whose fields are shown. */
  open: number | null;
  onOpen: (index: number | null) => void;
  /** Its sign, which may be seen for its number. */
  swatch: (index: number) => ComponentChildren;
  /** Whether that is so. */
  numbered?: boolean;
  /** Takes one away, where the key Delete does so. */
  onRemove?: (index: number) => void;
  /** The fields of the open one. */
  fields: (index: number) => ComponentChildren;
}

/** Maps under each other, one of which is open. */
export function MapList({ maps, open, onOpen, swatch, numbered = false, onRemove, fields }: MapListProps) {
  const list = useRef<HTMLOListElement>(null);
  const first = useRef(true);
  useEffect(() => {
    // What is chosen on the picture has its numbers in sight. What is open from the start stays below what is above it.
    if (open !== null && !first.current) list.current?.children[open]?.scrollIntoView({ block: "nearest" });
    first.current = false;
  }, [open]);
  return (
    <ol class={css["maps"]} ref={list}>
      {maps.map((words, index) => (
        // Maps have no name but their number: it is their key.
        <li key={index} class={`${css["map"]} ${open === index ? css["open"] : ""}`}>
          <button
            type="button"
            class={css["map-head"]}
            aria-expanded={open === index}
            onClick={() => onOpen(open === index ? null : index)}
            onKeyDown={(event) => {
              if (!onRemove || (event.key !== "Delete" && event.key !== "Backspace")) return;
              event.preventDefault();
              event.stopPropagation();
              onRemove(index);
            }}
          >
            {swatch(index)}
            {numbered ? (
              <span class="unseen">{messages.mapColon(index + 1)} </span>
            ) : (
              <span>{messages.mapNumber(index + 1)}</span>
            )}
            <span class={css["map-words"]}>{words}</span>
          </button>
          {open === index && <div class={css["map-body"]}>{fields(index)}</div>}
        </li>
      ))}
    </ol>
  );
}

interface MapToolsProps<Row> {
  maps: readonly Row[];
  index: number;
  /** How many there may be. */
  most: number;
  /** Takes other maps, opens one of them and says what was done. */
  onPress: (next: Row[], open: number, said: string) => void;
  /** The copy of one, where it is not the same in every number. */
  copyOf?: (row: Row) => Row;
  /** What else can be done to it. */
  children?: ComponentChildren;
}

const same = <Row,>(row: Row): Row => row;

/** What can be done to one map of several. */
export function MapTools<Row>({ maps, index, most, onPress, copyOf = same, children }: MapToolsProps<Row>) {
  return (
    <div class={css["map-tools"]}>
      <IconButton
        icon="copy"
        label={messages.duplicateThisMap}
        kind="quiet"
        disabled={maps.length >= most}
        onClick={() =>
          onPress(
            [...maps, ...maps.slice(index, index + 1).map(copyOf)],
            maps.length,
            messages.mapCopied(maps.length + 1, index + 1),
          )
        }
      />
      {children}
      <IconButton
        icon="bin"
        label={messages.removeThisMap}
        kind="quiet"
        disabled={maps.length < 2}
        onClick={() =>
          onPress(
            maps.filter((_, i) => i !== index),
            Math.max(0, index - 1),
            messages.mapRemoved(index + 1),
          )
        }
      />
    </div>
  );
}
