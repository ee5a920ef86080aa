import { fixed } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import tableCss from "../../kit/frame/table.module.css";
import type { Voting } from "./votes";

export function countWords(count: number): string {
  return count.toLocaleString("en-GB").replace(/,/g, " ");
}

/** How far the count is, and what stops it or begins it anew. */
export function VoteProgress({ voting }: { voting: Voting }) {
  const { state, share, votes, outcome, problem } = voting;
  const pass = share < 0.5 ? "first pass: a, b, c" : "second pass: d, e";
  const text = {
    running: `${countWords(votes)} votes, ${pass}`,
    stopped: `stopped after ${countWords(votes)} votes`,
    done: `${countWords(votes)} votes in ${fixed(outcome?.seconds ?? 0, 1)} s`,
    failed: problem,
  }[state];
  return (
    <div class={tableCss["measuring"]}>
      <progress max={1} value={share} aria-label="Counted" />
      {state === "running" ? (
        <Button onClick={voting.stop}>Stop</Button>
      ) : (
        <Button icon="reset" onClick={voting.again}>
          Count again
        </Button>
      )}
      <p class="number">{text}</p>
      <p class="unseen" role="status">
        {state === "running" ? "Counting votes" : text}
      </p>
    </div>
  );
}
