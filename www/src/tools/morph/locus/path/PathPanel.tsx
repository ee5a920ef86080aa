import { computed, useComputed } from "@preact/signals";
import { certified, certify, stopCertifying } from "#compute/certify";
import { leavesPlane, plan3, wayOf } from "#compute/plan";
import { along, locus, pathStates, plan, sought, stuck } from "#compute/results";
import { locusView, pathPoints } from "#document/morph";
import { edit } from "#document/scene";
import { certifiedWords, pathWords, roomWords } from "#format/path-words";
import { widestAlong } from "#geometry/polyline";
import { clearanceOf, isBroken, STATE } from "#geometry/states";
import { PathSection, WayPointEditor } from "#stage/locus/PathEditor";
import pathCss from "#stage/locus/path.module.css";
import { Button } from "#ui/controls/Button";
import type { PathKind } from "#wasm/api";
import { workers } from "#workers/pool/engine";
import { mode, pathKind } from "../../document-signals";
import { WayElse } from "../../later";
import * as messages from "../messages";
import { third } from "./automatic";
import { PATH } from "./handles";
import { bounds, MOST_W, showW, thirdShown } from "./waypoints";

function setKind(kind: PathKind): void {
  edit((before) => {
    if (kind === before.path.kind) return before;
    // The planned points come with the choice, so that undo and a link hold the path that is seen.
    const planned = plan.peek();
    if (kind === "auto") return { ...before, path: { kind, points: planned ? wayOf(planned) : [] } };
    if (kind === "straight") return { ...before, path: { kind, points: [] } };
    return { ...before, path: { ...before.path, kind } };
  });
}

/** What the path is, whether it holds, and its waypoints by numbers. */
export function PathPanel() {
  return (
    <PathSection kind={pathKind.value} onKind={setKind}>
      <PathVerdict />
      <NoWay />
      <WayPointEditor
        path={PATH}
        bounds={bounds.value}
        hint={messages.orDoubleClickPath}
        third={{ shown: thirdShown.value, most: MOST_W, ask: mode.value === "polar" && <AskThird /> }}
      />
      <Certificate />
    </PathSection>
  );
}

/** Whether it holds all the way, how wide its widest gap is, how much room it has. */
function PathVerdict() {
  const widest = useComputed(() => {
    const exact = along.value;
    if (exact) return exact.worst?.gap ?? 0;
    const field = locus.value;
    return field === null ? null : widestAlong(field, pathPoints.value);
  });
  const room = useComputed(() => {
    const field = locus.value;
    const points = pathPoints.value;
    if (leavesPlane(points)) return plan3.value?.plan?.clearance ?? null;
    return field && field.progress === 1 ? clearanceOf(field, points) : null;
  });
  const proof = certified.value;
  const words = sought.value
    ? messages.searchingForPath
    : pathWords({
        states: pathStates.value,
        widest: widest.value ?? 0,
        proved: proof?.holds === true && proof.done === proof.parts && proof.gap === 0,
        // What the map tells is not the last word: the moments of the path are looked at themselves.
        progress: along.value ? 1 : Math.min(0.99, locus.value?.progress ?? 0),
      });
  const breaks = breaksSeen.value || breaksHidden.value;
  return (
    <p class={`path-verdict ${breaks ? "broken" : "whole"}`}>
      <span class="mark" aria-hidden="true" />
      <span>
        {words} {!breaks && !sought.value && roomWords(room.value)}
      </span>
    </p>
  );
}

/** Whether the path is known to break: for all to see, or by a gap that only a proof shows. */
const breaksSeen = computed(() => !sought.value && pathStates.value.some(isBroken));
const breaksHidden = computed(() => !sought.value && pathStates.value.includes(STATE.hidden));

/** Where the automatic path cannot hold: says so, and what else there is. */
function NoWay() {
  // Who has met the third parameter may choose it; nobody else has to know of it while the plane has a path.
  const met = locusView.value.w !== 0 || thirdShown.value;
  return third.value || plan3.value?.plan === null || stuck.value || met ? <WayElse /> : null;
}

function AskThird() {
  return (
    <Button kind="quiet" description={messages.thirdNumberWHow} onClick={showW}>
      <span class="symbol">w</span>
    </Button>
  );
}

/** What can be proved of all of the path, not only of the moments that were looked at. */
function Certificate() {
  const now = certified.value;
  // What is known to break has no proof that it does not.
  if (now === null && breaksSeen.value) return null;
  const running = now !== null && now.problem === null && now.done < now.parts;
  return (
    <div class={pathCss["path-proof"]}>
      {running ? (
        <>
          <div class={pathCss["path-proof-bar"]}>
            <progress aria-label={messages.proofPath} max={1} value={now.done / now.parts} />
            <Button kind="quiet" onClick={stopCertifying}>
              {messages.cancel}
            </Button>
          </div>
          <p class="hint">{certifiedWords(now)}</p>
        </>
      ) : now === null ? (
        <Button
          kind="quiet"
          description={messages.soFarFrondHas}
          disabled={!workers.value.available && along.value === null}
          onClick={certify}
        >
          {breaksHidden.value ? messages.tryToBoundGaps : messages.tryToProveWhole}
        </Button>
      ) : (
        <p class={pathCss["path-proved"]} role="status">
          {certifiedWords(now)}{" "}
          {now.joints > 0 && (
            <a href="./theorems.html#joints" target="_blank" rel="noopener">
              {messages.whyProof}
            </a>
          )}
        </p>
      )}
    </div>
  );
}
