import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { announce, wordsOf } from "#document/notice";
import { formatNumber } from "#format/numbers";
import { nearlySame } from "#geometry/maps/hand";
import type { Row } from "#geometry/maps/row";
import { Button } from "../controls/Button";
import * as messages from "../messages";
import { Problem } from "../panel/Problem";
import css from "./hand.module.css";

interface MatrixFieldsProps<Map extends Row> {
  /** All that was done to it. */
  moved: Map;
  /** A field a number. */
  fields: (map: Map, onChange: (map: Map) => undefined) => ComponentChildren;
  /** By what its volumes or areas are multiplied. */
  sizes: "Volumes" | "Areas";
  determinant: (map: Map) => number;
  /** What it is called. */
  name: string;
  place: (put: Map) => void;
}

/** All that was done to it as one matrix and a translation, of which every number can be another. */
export function MatrixFields<Map extends Row>(props: MatrixFieldsProps<Map>) {
  const { moved: now, fields, sizes, determinant, name, place } = props;
  const [draft, setDraft] = useState<{ from: Map; to: Map } | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  // What was typed holds until it goes somewhere else.
  const typed = draft && nearlySame(draft.from, now) ? draft.to : null;
  const shown = typed ?? now;
  const times = determinant(shown);
  return (
    <div class="stack">
      <p class="hint">{messages.wholeTransformationXX}</p>
      {fields(shown, (next) => {
        setDraft({ from: now, to: next });
        setProblem(null);
        return undefined;
      })}
      <div class="row">
        <span class="row-name">
          {times === 0
            ? messages.matrixFlatSoCannot
            : messages.sizesTimes(
                sizes,
                formatNumber(Math.abs(times), 3),
                times < 0 ? messages.mirroredToo : "",
              )}
        </span>
        <span class={css["buttons"]}>
          <Button
            kind="quiet"
            disabled={typed === null}
            onClick={() => {
              setDraft(null);
              setProblem(null);
            }}
          >
            {messages.discard}
          </Button>
          <Button
            kind="primary"
            disabled={typed === null}
            onClick={() => {
              try {
                place(shown);
                setDraft(null);
                setProblem(null);
                announce(messages.movedThere(name));
              } catch (thrown) {
                setProblem(messages.staysThere(wordsOf(thrown), name));
              }
            }}
          >
            {messages.apply}
          </Button>
        </span>
      </div>
      <Problem words={problem} />
    </div>
  );
}
