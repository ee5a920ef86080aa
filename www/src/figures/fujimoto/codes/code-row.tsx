import css from "./code-row.module.css";

/** Codes written out letter by letter. */

interface CodeRowProps {
  code: readonly number[];
  /** So many of the first letters count; the others are pale. */
  strong?: number;
  /** The letters from..to - 1 belong together: the block that is reversed. */
  block?: { from: number; to: number };
  /** Whether it goes on. */
  more?: boolean;
}

/** A code as a row of letters, from 1. */
export function CodeRow({ code, strong = code.length, block, more = false }: CodeRowProps) {
  return (
    <span class={`${css["code-row"]} number`}>
      {code.map((letter, place) => {
        const within = block !== undefined && place >= block.from && place < block.to;
        return (
          <span
            key={place}
            class={`${css["code-letter"]} ${place < strong ? "" : css["pale"]} ${within ? css["within"] : ""}`}
          >
            {letter + 1}
          </span>
        );
      })}
      {more && <span class={`${css["code-letter"]} ${css["pale"]}`}>…</span>}
    </span>
  );
}
