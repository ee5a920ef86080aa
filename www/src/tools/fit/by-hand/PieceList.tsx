import { computed } from "@preact/signals";
import type { VNode } from "preact";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import css from "../graph/graph.module.css";
import * as messages from "../messages";
import { IndexSelect } from "./IndexSelect";

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
