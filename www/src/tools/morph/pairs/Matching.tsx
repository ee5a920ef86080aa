import { pieceColours } from "#document/colours";
import "#ui/panel/fold.css";
import { useLayoutEffect, useRef } from "preact/hooks";
import { BOUNDS } from "#compute/locus/job";
import { lookForMatchings, matchings, stopMatching } from "#compute/matching";
import { wayOf } from "#compute/plan";
import { announce } from "#document/notice";
import { dark } from "#document/preferences";
import { edit } from "#document/scene";
import { matchWords, meritWords } from "#format/path-words";
import { paint } from "#stage/locus/paint";
import { Button } from "#ui/controls/Button";
import { useOwnId } from "#ui/id";
import type { RatedCandidate } from "#wasm/api";
import { matchingOpen } from "../dialogs";
import { correspondence, turns } from "../document-signals";
import { place } from "../locus/path/waypoints";
import { isMatched, takeMatching } from "../ways";
import * as messages from "./messages";
import css from "./pairs.module.css";

/** Other ways to match the maps, each with its own map of where it holds. */
export function Matching() {
  const found = matchings.value;
  return (
    <details
      class={`fold ${css["pairs-more"]}`}
      id="matching"
      open={matchingOpen.value}
      onToggle={(event) => {
        const { open } = event.currentTarget;
        matchingOpen.value = open;
        if (open && matchings.peek() === null) lookForMatchings();
      }}
    >
      <summary>{messages.otherPairings}</summary>
      {found === null ? (
        <Button onClick={lookForMatchings}>{messages.searchAgain}</Button>
      ) : (
        <>
          <Progress />
          {found.rated.length > 0 && <Cards rated={found.rated} />}
        </>
      )}
    </details>
  );
}

function Progress() {
  const found = matchings.value;
  if (found === null) return null;
  const { of, done, problem } = found;
  if (problem !== null) return <p class="hint">{problem}</p>;
  if (of === 0) return <p class="hint">{messages.thereNoOtherSensible}</p>;
  if (of !== null && done >= of) return <p class="hint">{messages.bestFirstPairingsWithout}</p>;
  return (
    <div class={css["pairs-progress"]}>
      <progress
        aria-label={messages.tryingOtherPairings}
        {...(of === null ? {} : { max: of, value: done })}
      />
      <span class="hint">{of === null ? messages.searching : messages.doneOf(done, of)}</span>
      <Button kind="quiet" onClick={stopMatching}>
        {messages.cancel}
      </Button>
    </div>
  );
}

const keyOf = ({ correspondence, turns }: RatedCandidate) => `${correspondence.join()} ${turns.join()}`;

function Cards({ rated }: { rated: readonly RatedCandidate[] }) {
  const name = useOwnId("matching");
  const now = { correspondence: correspondence.value, turns: turns.value };
  return (
    <div class={css["matching-cards"]} role="radiogroup" aria-label={messages.pairings}>
      {rated.map((candidate) => (
        <Card key={keyOf(candidate)} name={name} candidate={candidate} chosen={isMatched(now, candidate)} />
      ))}
    </div>
  );
}

function Card({ name, candidate, chosen }: { name: string; candidate: RatedCandidate; chosen: boolean }) {
  const { plan } = candidate;
  const words = matchWords(candidate.correspondence, candidate.turns);
  const merit = meritWords(plan);
  return (
    <label class={`${css["matching-card"]} ${plan.holds ? "" : css["breaks"]}`} title={words}>
      <input
        class="covering"
        type="radio"
        name={name}
        checked={chosen}
        aria-label={`${words}: ${merit}`}
        onChange={() => {
          edit((before) => takeMatching(before, candidate, wayOf(plan)));
          announce(`${words}: ${merit}.`);
        }}
      />
      <Thumb candidate={candidate} />
      <Arrows becomes={candidate.correspondence} turns={candidate.turns} />
      <span class={css["matching-merit"]} aria-hidden="true">
        <span class="mark" />
        {merit}
      </span>
    </label>
  );
}

const SIZE = 128;

/** The candidate's own locus, with its path. */
function Thumb({ candidate }: { candidate: RatedCandidate }) {
  const { locus, plan } = candidate;
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const field = { ...locus, bounds: BOUNDS, progress: 1 };
    const pixels = paint(field, SIZE, { style: "gap" });
    canvas.current?.getContext("2d")?.putImageData(new ImageData(pixels, SIZE, SIZE), 0, 0);
  }, [locus]);
  const line = plan.points.map((point) => place(point, BOUNDS).map((x) => (100 * x).toFixed(1))).join(" ");
  return (
    <span class={css["matching-thumb"]} aria-hidden="true">
      <canvas ref={canvas} width={SIZE} height={SIZE} />
      <svg viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">
        <polyline class="path-casing" points={line} />
        <polyline class={plan.holds ? "path-core" : "path-core broken"} points={line} />
      </svg>
    </span>
  );
}

/** More lines than that cannot be told apart: then the words alone say it. */
const MOST_ARROWS = 12;
const STEP = 18;

/** Maps of A above, of B below, a line from each to what it becomes; a ring for each turn more. */
function Arrows({ becomes, turns }: { becomes: readonly number[]; turns: readonly number[] }) {
  const colours = pieceColours(dark.value ? "dark" : "light");
  if (becomes.length > MOST_ARROWS)
    return <span class={css["matching-words"]}>{matchWords(becomes, turns)}</span>;
  const x = (i: number) => STEP * (i + 0.5);
  return (
    <svg class={css["matching-arrows"]} viewBox={`0 0 ${STEP * becomes.length} 48`} aria-hidden="true">
      {becomes.map((to, from) => (
        <g key={from} style={{ color: colours[from % colours.length] ?? "gray" }}>
          <path d={`M${x(from)} 14L${x(to)} 34`} />
          {(turns[from] ?? 0) !== 0 && (
            <circle cx={(x(from) + x(to)) / 2} cy={24} r={3.5} class={css["matching-turn"]} />
          )}
          <text x={x(from)} y={11}>
            {from + 1}
          </text>
        </g>
      ))}
      {becomes.map((_, i) => (
        <text key={i} x={x(i)} y={45}>
          {i + 1}
        </text>
      ))}
    </svg>
  );
}
