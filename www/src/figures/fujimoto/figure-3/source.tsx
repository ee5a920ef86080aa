import { Panel } from "../../kit/frame/panel";
import type { Point } from "../../kit/maps/pieces";
import { CodeRow } from "../codes/code-row";
import { codeOf, codeWords, shuffled } from "../codes/codes";
import { Cell, type Chosen, COLUMNS, Outline } from "./shuffle-matrix";
import shuffleMatrixCss from "./shuffle-matrix.module.css";
import type { Subject } from "./shuffled-image";
import css from "./source.module.css";

const SQUARE = { dimensions: 2, parts: 2 } as const;

interface SourceProps {
  subject: Subject;
  chosen: Chosen;
  point: Point;
}

/** Where the colour of a cell came from: the picture before the shuffle, and the code letter by letter. */
export function Source({ subject, chosen, point }: SourceProps) {
  const { kb, ke, superposed } = chosen;
  const code = codeOf(SQUARE, point, COLUMNS);
  const from = depthsOf(kb, ke, superposed).map((depth) => ({ depth, code: shuffled(code, kb, depth) }));
  const words = [...new Set(from.map((one) => codeWords(one.code)))];
  return (
    <Panel
      name="Before the shuffle"
      caption={<>The colour came from {from.length > 1 ? `these ${words.length} cells, mixed` : "here"}.</>}
    >
      <span class={shuffleMatrixCss["shuffled"]}>
        <Cell
          subject={subject}
          chosen={{ kb, ke: kb, superposed: false }}
          label={`Before the shuffle: cell ${codeWords(code)} takes its colour from ${words.join(", ")}.`}
        />
        <svg viewBox="0 0 128 128" aria-hidden="true">
          <Outline subject={subject} code={code.slice(0, kb)} kind="frame" />
          {from.map((one) => (
            <Outline key={one.depth} subject={subject} code={one.code} kind="from" />
          ))}
        </svg>
      </span>
    </Panel>
  );
}

/** The code of a cell, and below it what the shuffle makes of it, letter by letter. */
export function Letters({ chosen: { kb, ke, superposed }, point }: Omit<SourceProps, "subject">) {
  const code = codeOf(SQUARE, point, COLUMNS);
  return (
    <dl class={css["code-steps"]}>
      <div>
        <dt>the cell</dt>
        <dd>
          <CodeRow code={code} block={{ from: kb, to: ke }} />
        </dd>
      </div>
      {depthsOf(kb, ke, superposed).map((depth) => (
        <div key={depth}>
          <dt>
            {depth - kb < 2
              ? `${superposed ? `ke ${depth}: ` : ""}nothing to reverse`
              : `letters ${kb + 1} to ${depth} reversed`}
          </dt>
          <dd>
            <CodeRow code={shuffled(code, kb, depth)} block={{ from: kb, to: depth }} />
          </dd>
        </div>
      ))}
    </dl>
  );
}

function depthsOf(kb: number, ke: number, superposed: boolean): number[] {
  return superposed ? Array.from({ length: ke - kb + 1 }, (_, i) => kb + i) : [ke];
}
