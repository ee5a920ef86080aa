import { computed } from "@preact/signals";
import type { VNode } from "preact";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import { Select } from "#ui/controls/Select";
import css from "../graph/graph.module.css";
import * as messages from "../messages";

/** Up to here all pieces have a row; beyond, the chosen one has. */
const ALL = 12;

const colours = computed(() => palette(dark.value ? "dark" : "light"));

/** The colour of a piece, in its row as on the stage. */
export const colourOf = (piece: number): string => colours.value[piece % colours.value.length] ?? "gray";

interface PieceListProps {
  id: string;
  count: number;
  chosen: number;
  onChoose: (piece: number) => void;
  row: (piece: number, open: boolean) => VNode;
}

/** A row for each piece, the chosen one open. */
export function PieceList({ id, count, chosen, onChoose, row }: PieceListProps) {
  const open = Math.min(chosen, count - 1);
  const shown = count <= ALL ? Array.from({ length: count }, (_, i) => i) : [open];
  return (
    <>
      {count > ALL && (
        <div class="row">
          <label class="row-name" for={id}>
            {messages.pieceOf(count)}
          </label>
          <IndexSelect id={id} value={open} count={count} onChange={onChoose} />
        </div>
      )}
      <ol class={css["graph-pieces"]}>{shown.map((piece) => row(piece, piece === open))}</ol>
    </>
  );
}

/** The number of a piece, which opens its row. */
export function PieceNumber({
  piece,
  open,
  onChoose,
}: {
  piece: number;
  open: boolean;
  onChoose: (piece: number) => void;
}) {
  return (
    <button
      type="button"
      class={css["piece-number"]}
      aria-expanded={open}
      aria-label={messages.pieceNumber(piece + 1)}
      onClick={() => onChoose(piece)}
    >
      {piece + 1}
    </button>
  );
}

interface IndexSelectProps {
  /** What is chosen, where no label element says it. */
  label?: string;
  id?: string;
  value: number;
  count: number;
  onChange: (index: number) => void;
}

/** One of so many, by its number; the first is 1. */
export function IndexSelect({ label, id, value, count, onChange }: IndexSelectProps) {
  return (
    <Select
      id={id}
      aria-label={label}
      value={value}
      onChange={(event) => onChange(Number(event.currentTarget.value))}
    >
      {Array.from({ length: count }, (_, i) => (
        <option key={i} value={i}>
          {i + 1}
        </option>
      ))}
    </Select>
  );
}

interface CopiedSpanProps {
  piece: number;
  /** From which point to which, by their places. */
  span: readonly [number, number];
  /** Of how many points. */
  count: number;
  onChange: (end: 0 | 1, point: number) => void;
}

/** What a piece copies: from point to point. */
export function CopiedSpan({ piece, span, count, onChange }: CopiedSpanProps) {
  return (
    <p class={css["piece-domain"]}>
      <span class="row-name">{messages.copiesFromPoint}</span>
      {([0, 1] as const).map((end) => (
        <IndexSelect
          key={end}
          label={messages.copiedEnd(piece + 1, end !== 0)}
          value={span[end]}
          count={count}
          onChange={(point) => onChange(end, point)}
        />
      ))}
    </p>
  );
}
