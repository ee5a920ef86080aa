import { useState } from "preact/hooks";
import { announce, wordsOf } from "#document/notice";
import { placeObject } from "#document/space/edits";
import { formatNumber } from "#format/numbers";
import { determinant3 } from "#geometry/maps/affine3";
import { Button } from "#ui/controls/Button";
import { Problem } from "#ui/panel/Problem";
import type { MapRow3 } from "#wasm/api";
import { moved } from "../now";
import shapeCss from "../shape.module.css";
import { nearlySame } from "./hand";
import { TwelveFields } from "./TwelveFields";

/** All that was done to the object as one matrix and a translation, of which every number can be another. */
export function MatrixFields() {
  const now = moved.value;
  const [draft, setDraft] = useState<{ from: MapRow3; to: MapRow3 } | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  // What was typed holds until the object goes somewhere else.
  const typed = draft && nearlySame(draft.from, now) ? draft.to : null;
  const shown = typed ?? now;
  const times = determinant3(shown);
  return (
    <div class="stack">
      <p class="hint">All that was done to it: x′ = A x + b.</p>
      <TwelveFields
        map={shown}
        onChange={(next) => {
          setDraft({ from: now, to: next });
          setProblem(null);
          return undefined;
        }}
        onDone={() => {}}
      />
      <div class="row">
        <span class="row-name">
          {times === 0
            ? "Flat: it cannot be undone."
            : `Volumes times ${formatNumber(Math.abs(times), 3)}${times < 0 ? ", mirrored" : ""}`}
        </span>
        <span class={shapeCss["solid-buttons"]}>
          <Button
            kind="quiet"
            disabled={typed === null}
            onClick={() => {
              setDraft(null);
              setProblem(null);
            }}
          >
            Discard
          </Button>
          <Button
            kind="primary"
            disabled={typed === null}
            onClick={() => {
              try {
                placeObject(shown);
                setDraft(null);
                setProblem(null);
                announce("The object has been moved there.");
              } catch (thrown) {
                setProblem(`${wordsOf(thrown)} The object stays where it is.`);
              }
            }}
          >
            Apply
          </Button>
        </span>
      </div>
      <Problem words={problem} />
    </div>
  );
}
