import css from "../graph/graph.module.css";
import * as messages from "../messages";
import { IndexSelect } from "./IndexSelect";

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
