import "#stage/locus/path.css";
import { endGesture } from "#document/scene";
import { bestWords, pathWords, roomWords } from "#format/path-words";
import { shareOf, stateOf } from "#format/verdict";
import { isBroken, STATE, widestOf } from "#geometry/states";
import { Button, IconButton } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import type { PathKind } from "#wasm/api";
import { MOST_POINTS } from "./changes";
import { focusHandle } from "./handles";
import { addAfter, addHere, chosen, moveTo, removeAt, setKind, stateAt, way } from "./way";
import { calledOff, callOff, check, found, lookAgain, morph, pathless, search, searchProblem } from "./work";

const KINDS: readonly { value: PathKind; label: string; description: string }[] = [
  { value: "auto", label: "Auto", description: "The way with the narrowest gap, found for you" },
  { value: "straight", label: "Straight", description: "Turn, stretch and move together, at one pace" },
  { value: "drawn", label: "Drawn", description: "Through your own way points" },
];

/** What the path is, whether it holds, and its way points by numbers. */
export function PathPanel() {
  const kind = morph.value?.path.kind ?? "auto";
  return (
    <section class="path" aria-labelledby="path3-title">
      <header class="section-head">
        <h2 id="path3-title">Path</h2>
        <Segmented label="Kind of path" value={kind} options={KINDS} onChange={setKind} />
      </header>
      <div class="morph3-path">
        {kind === "auto" && search.value ? <Searching share={search.value.share} /> : <PathVerdict />}
        {kind === "auto" && <Ended />}
      </div>
      {chosen.value === null ? <WayNone /> : <WayPoint index={chosen.value} />}
    </section>
  );
}

/** How far the search is, and its end. */
function Searching({ share }: { share: number }) {
  return (
    <>
      <div class="path-proof-bar">
        <progress aria-label="Search for a path" max={1} {...(share > 0 ? { value: share } : {})} />
        <Button kind="quiet" onClick={callOff}>
          Cancel
        </Button>
      </div>
      <p class="hint" role="status">
        {pathless.value ? "A path on which it holds together is looked for." : "A better path is looked for."}
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
        Look again
      </Button>
    </div>
  );
}

function endedWords(some: boolean): string {
  return some
    ? "The search was ended. This is the best path so far."
    : "The search was ended before it had found a path: this one is straight.";
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
        class={`path-verdict ${breaks ? "broken" : so ? "whole" : "space-undecided"}`}
        data-testid="space-path"
      >
        <span class="mark" aria-hidden="true" />
        <span>
          {words} {settled && !breaks && roomWords(best.plan.clearance)}
        </span>
      </p>
      {settled && !so.holds && (
        <p class="hint">
          {bestWords(best.plan.apart === true, false)} Another way to match the maps, or other shapes, may
          have one.
        </p>
      )}
    </>
  );
}

function WayNone() {
  return (
    <div class="way-none">
      <Button
        icon="add"
        disabled={way.value.length >= MOST_POINTS}
        description="Add a way point where the picture is now"
        onClick={() => focusHandle(addHere())}
      >
        Add way point
      </Button>
      <span class="hint">or press twice on the map</span>
    </div>
  );
}

/** One way point by its numbers. */
function WayPoint({ index }: { index: number }) {
  const point = way.value[index];
  if (!point) return null;
  const [u, v] = point;
  const gesture = `space-way-${index}`;
  return (
    <fieldset class="way-point">
      <legend>
        Way point {index + 1} of {way.value.length} <span class="dim">{stateAt(index)}</span>
      </legend>
      <NumberField
        terse
        label="turn and stretch, u"
        symbol="u"
        value={u}
        min={-1}
        max={2}
        digits={3}
        onChange={(next) => moveTo(index, [next, v], gesture)}
        onDone={endGesture}
      />
      <NumberField
        terse
        label="move, v"
        symbol="v"
        value={v}
        min={-1}
        max={2}
        digits={3}
        onChange={(next) => moveTo(index, [u, next], gesture)}
        onDone={endGesture}
      />
      <div class="way-tools">
        <IconButton
          icon="add"
          label="Add a way point after this one"
          kind="quiet"
          disabled={way.value.length >= MOST_POINTS}
          onClick={() => focusHandle(addAfter(index))}
        />
        <IconButton
          icon="bin"
          label="Remove this way point"
          kind="quiet"
          onClick={() => {
            removeAt(index);
            focusHandle(null);
          }}
        />
      </div>
    </fieldset>
  );
}
