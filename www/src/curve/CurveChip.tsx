import { computed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { sameCurves } from "#document/curve/changes";
import { curves } from "#document/curve/curve";
import { playing } from "#document/playback";
import { useSaidAtRest } from "#stage/evidence/aloud";
import { EvidenceChip } from "#stage/evidence/Chip";
import { EvidencePanel } from "#stage/evidence/Panel";
import stageCss from "#stage/stage.module.css";
import { VerdictSign } from "#ui/shapes/VerdictSign";
import css from "./curve.module.css";
import { factsNow, watchFacts } from "./facts";
import * as messages from "./messages";
import { crossingWords, whyWords } from "./words";

const PANEL_ID = "curve-evidence";
const CHIP_ID = "curve-chip";

const crossings = computed(() => factsNow.value?.crossings ?? 0);
const names = computed(() => {
  const now = curves.value;
  return now && !sameCurves(now) ? { a: now.a.name, b: now.b.name } : null;
});

const asideOf = (count: number) => crossingWords(count) || messages.byConstruction;

/** That the curve is in one piece, as it is by construction, and whether it crosses itself; pressed, it tells why. */
export function CurveChip() {
  useEffect(watchFacts, []);
  useSaidAtRest(() => ({
    text: factsNow.value ? messages.oneCurve(asideOf(factsNow.value.crossings)) : "",
    moving: playing.value,
  }));
  const crosses = crossingWords(crossings.value);
  return (
    <EvidenceChip id={CHIP_ID} panel={PANEL_ID}>
      {crosses === "" ? (
        <VerdictSign tone="whole" />
      ) : (
        <svg class="sign" width="1rem" height="1rem" viewBox="0 0 16 16" aria-hidden="true">
          <path
            class={css["curve-sign"]}
            d="M8 8C11 4 14.500 5 14.500 8S11 12 8 8 1.500 11 1.500 8 5 4 8 8z"
          />
        </svg>
      )}
      <span class={stageCss["chip-text"]}>{messages.oneClosedCurve}</span>
      <span class={stageCss["chip-aside"]}>{asideOf(crossings.value)}</span>
    </EvidenceChip>
  );
}

/** Why it is one closed curve. */
export function CurveEvidence() {
  const crosses = crossingWords(crossings.value);
  return (
    <EvidencePanel id={PANEL_ID} chip={CHIP_ID} title={messages.oneClosedCurveBy}>
      <p>{whyWords(names.value)}</p>
      <p>{crosses === "" ? messages.atThisMomentDoes : messages.mayCross(crosses)}</p>
    </EvidencePanel>
  );
}
