import { BOUNDS } from "#compute/locus/job";
import { bestWords, pathWords, roomWords } from "#format/path-words";
import { shareOf, stateOf } from "#format/verdict";
import { isBroken, STATE, widestOf } from "#geometry/states";
import { PathSection, WayPointEditor } from "#stage/locus/PathEditor";
import pathCss from "#stage/locus/path.module.css";
import { Button } from "#ui/controls/Button";
import * as messages from "../messages";
import { PATH } from "./handles";
import css from "./morph3.module.css";
import { setKind, way } from "./waypoints";
import { calledOff, callOff, check, found, lookAgain, morph, pathless, search, searchProblem } from "./work";

/** What the path is, whether it holds, and its waypoints by numbers. */
export function PathPanel() {
  const kind = morph.value?.path.kind ?? "auto";
  return (
    <PathSection kind={kind} onKind={setKind}>
      <div class={css["morph3-path"]}>
        {kind === "auto" && search.value ? <Searching share={search.value.share} /> : <PathVerdict />}
        {kind === "auto" && <Ended />}
      </div>
      <WayPointEditor path={PATH} bounds={BOUNDS} hint={messages.orDoubleClickLocus} />
    </PathSection>
  );
}

/** How far the search is, and its end. */
function Searching({ share }: { share: number }) {
  return (
    <>
      <div class={pathCss["path-proof-bar"]}>
        <progress aria-label={messages.searchForPath} max={1} {...(share > 0 ? { value: share } : {})} />
        <Button kind="quiet" onClick={callOff}>
          {messages.cancel}
        </Button>
      </div>
      <p class="hint" role="status">
        {pathless.value ? messages.frondSearchingForPath : messages.frondSearchingForBetter}
      </p>
    </>
  );
}

/** What became of a search that came to no end. */
function Ended() {
  const problem = searchProblem.value;
  if (search.value || (problem === null && !calledOff.value)) return null;
  return (
    <div class="row" role="status">
      <span class="hint">{problem ?? endedWords(way.value.length > 0)}</span>
      <Button kind="quiet" icon="reset" onClick={lookAgain}>
        {messages.searchAgain}
      </Button>
    </div>
  );
}

function endedWords(some: boolean): string {
  return some ? messages.youEndedSearchThis : messages.youEndedSearchBefore;
}

function PathVerdict() {
  const kind = morph.value?.path.kind;
  const so = check.value;
  const states = (so?.told ?? []).map((moment) => stateOf(moment));
  const breaks = states.some((state) => isBroken(state) || state === STATE.hidden);
  const worst = widestOf(states, so?.told.map(shareOf) ?? []);
  const words = pathWords({ states, widest: worst?.gap ?? 0, progress: so ? 1 : 0 });
  const best = kind === "auto" ? (found.value?.path ?? null) : null;
  const settled = best && so;
  return (
    <>
      <p
        class={`path-verdict ${breaks ? "broken" : so ? "whole" : css["space-undecided"]}`}
        data-testid="space-path"
      >
        <span class="mark" aria-hidden="true" />
        <span>
          {words} {settled && !breaks && roomWords(best.plan.clearance)}
        </span>
      </p>
      {settled && !so.holds && (
        <p class="hint">{messages.orOtherPairing(bestWords(best.plan.apart === true, false))}</p>
      )}
    </>
  );
}
