import { useMemo } from "preact/hooks";
import type { Box } from "#document/framing";
import { Button } from "#ui/controls/Button";
import type { Connectedness } from "#wasm/api";
import { Graph } from "../../kit/connectedness/overlap-graph";
import layout from "../../kit/frame/layout.module.css";
import { EXACT, VerdictChip } from "../../kit/frame/verdict";
import { Drawn, middles, PieceNames } from "../../kit/picture/annotated";
import { list, whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { useVerdict } from "../../kit/workers";
import { Exercise } from "../frame/exercise";
import lessonCss from "../frame/lesson.module.css";
import { cornersOf, hangTogether, isDeceiving, isStar, mapsOf } from "./cells";
import css from "./page.module.css";

const SQUARE: Box = { x0: 0, y0: 0, x1: 1, y1: 1 };
const FIRST = [0, 1, 2];
const STORED = list(whole(0, 8), 0, 9);

export function Exercises() {
  return (
    <>
      <Star />
      <Deceiving />
    </>
  );
}

/** A graph that is asked for. */
function Star() {
  const [cells, setCells] = useKept<readonly number[]>("x1.cells", FIRST, STORED);
  const { answer, stale } = useAnswer(cells);
  return (
    <Exercise
      number={1}
      ask="Each piece of this shape is the whole, a third as large, in one of nine cells. Choose five cells so that the overlap graph is a star: one dot has a line to each of the other four, and there are no more lines."
      hints={[
        "One piece has to touch all others. Which cell has most neighbours?",
        "The middle cell and four more. Now choose four that do not touch each other, though they are all next to the middle.",
      ]}
      solved={stale ? null : cells.length === 5 && answer !== null && isStar(5, answer.overlaps)}
      status={
        cells.length !== 5
          ? `${cells.length} cells; there are to be five.`
          : answer && !stale
            ? `${answer.overlaps.length} lines.`
            : "Looking …"
      }
    >
      <Chosen cells={cells} onCells={setCells} answer={stale ? null : answer} />
    </Exercise>
  );
}

/** Cells that share an edge, and pieces that do not touch. */
function Deceiving() {
  const [cells, setCells] = useKept<readonly number[]>("x2.cells", FIRST, STORED);
  const { answer, stale } = useAnswer(cells);
  const solved = stale || !answer ? null : isDeceiving(cells, answer);
  const words =
    cells.length < 2
      ? "Choose two cells at least."
      : !hangTogether(cells)
        ? "These cells do not hang together by edges: that the shape is in pieces would surprise nobody."
        : solved === null
          ? "Looking …"
          : solved
            ? "The cells share an edge, and what lies in them does not reach it."
            : "The cells hang together, and so does the shape.";
  return (
    <Exercise
      number={2}
      ask="Choose cells that hang together by whole edges, and yet the shape is in pieces: proved, not only seen."
      hints={[
        "It takes few cells. What does the shape of one row of three look like, and what if one of them goes?",
        "Take two cells one beside the other. What is left of the lower edge of each?",
      ]}
      solved={solved}
      status={words}
    >
      <Chosen cells={cells} onCells={setCells} answer={stale ? null : answer} />
    </Exercise>
  );
}

function useAnswer(cells: readonly number[]): { answer: Connectedness | null; stale: boolean } {
  const maps = useMemo(() => (cells.length > 1 ? mapsOf(cells) : null), [cells]);
  const judged = useVerdict(maps, EXACT);
  return { answer: maps ? (judged?.answer ?? null) : null, stale: maps !== null && judged?.maps !== maps };
}

interface ChosenProps {
  cells: readonly number[];
  onCells: (cells: readonly number[]) => void;
  answer: Connectedness | null;
}

/** Nine cells to choose from, the shape of those that are chosen, and its overlap graph. */
function Chosen({ cells, onCells, answer }: ChosenProps) {
  const maps = useMemo(() => mapsOf(cells), [cells]);
  const toggle = (cell: number) =>
    onCells(
      cells.includes(cell) ? cells.filter((one) => one !== cell) : [...cells, cell].sort((p, q) => p - q),
    );
  const edges = (answer?.overlaps ?? []).map(([i, j]) => ({
    between: [i, j] as [number, number],
    at: 0,
    pixel: 0,
  }));
  // Round the middle of the square; the middle cell itself lies anywhere.
  const angles = cells.map((cell, i) => Math.atan2(Math.floor(cell / 3) - 1, (cell % 3) - 1) + i * 1e-3);
  return (
    <div class={css["cells-row"]}>
      {/* biome-ignore lint/a11y/useSemanticElements: a fieldset of buttons has no value */}
      <div class={css["cells"]} role="group" aria-label="Cells">
        {[6, 7, 8, 3, 4, 5, 0, 1, 2].map((cell) => (
          <Button key={cell} pressed={cells.includes(cell)} onClick={() => toggle(cell)}>
            <span class="unseen">{cellWords(cell)}</span>
            <span aria-hidden="true">{cells.includes(cell) ? cells.indexOf(cell) + 1 : "·"}</span>
          </Button>
        ))}
      </div>
      {cells.length > 1 ? (
        <>
          <Drawn form="square" maps={maps} box={SQUARE} label={`The shape of ${cells.length} cells.`}>
            {(place) => (
              <>
                {cells.map((cell) => (
                  <path
                    key={cell}
                    class={css["cell"]}
                    d={`M${cornersOf(cell)
                      .map((corner) => place(corner).join(" "))
                      .join("L")}Z`}
                  />
                ))}
                <PieceNames at={middles(maps, SQUARE).map(place)} />
              </>
            )}
          </Drawn>
          <div class={lessonCss["ask"]}>
            <Graph count={cells.length} angles={angles} still edges={edges} />
            <VerdictChip epsilon={EXACT} answer={answer} />
          </div>
        </>
      ) : (
        <p class={layout["hint"]}>Of fewer than two cells there is nothing to see.</p>
      )}
    </div>
  );
}

const cellWords = (cell: number) =>
  `${["lower", "middle", "upper"][Math.floor(cell / 3)]} ${["left", "middle", "right"][cell % 3]} cell`;
