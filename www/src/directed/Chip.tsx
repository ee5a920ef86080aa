import { playing } from "#document/playback";
import { lineOf, verdictPhrase, verdictWords } from "#format/verdict";
import { answerNow, isStale, toldNow, toldStates, wordsNow } from "#stage/directed/known";
import { useSaidAtRest } from "#stage/evidence/aloud";
import { VerdictChip } from "#stage/evidence/Chip";
import { EvidencePanel } from "#stage/evidence/Panel";
import { VerdictSign } from "#ui/shapes/VerdictSign";
import css from "./directed.module.css";
import { Answer, Remarks } from "./Found";
import * as messages from "./messages";
import { madeOf } from "./systems";

const PANEL_ID = "directed-evidence";
const CHIP_ID = "directed-chip";

/** What holds for the graph-directed shape on the stage, in words; pressed, it tells what holds for each state. */
export function DirectedChip() {
  useSaidAtRest(() => ({
    text: toldNow.value ? lineOf(wordsNow.value) : "",
    moving: playing.value || isStale.value,
  }));
  return <VerdictChip id={CHIP_ID} panel={PANEL_ID} stale={isStale.value} words={wordsNow.value} />;
}

/** As many states are listed. */
const MOST_SHOWN = 24;

/** What is known of every state. */
export function DirectedEvidence() {
  const answer = answerNow.value;
  const states = toldStates.value;
  const always = states[0]?.verdict === "connected" && answer?.states[0]?.verdict !== "connected";
  return (
    <EvidencePanel id={PANEL_ID} chip={CHIP_ID} title={messages.whatKnownAboutEach}>
      {answer === null && <p>{verdictPhrase(toldNow.value)}</p>}
      {always ? <p>{messages.inOnePieceAt}</p> : <Answer of={answer?.states[0]} />}
      <ol class={css["states"]}>
        {states.slice(0, MOST_SHOWN).map((state, k) => (
          <li key={k}>
            <VerdictSign tone={verdictWords(state).tone} />
            <span>
              {(k === 0 && states.length > 1 ? messages.shapeStateIs : messages.stateIs)(
                k + 1,
                verdictPhrase(state),
              )}
              <small>{madeOf(answer?.system.states[k] ?? [])}</small>
            </span>
          </li>
        ))}
      </ol>
      {states.length > MOST_SHOWN && <p class="hint">{messages.moreStates(states.length - MOST_SHOWN)}</p>}
      {answer && <Remarks {...answer.facts} />}
    </EvidencePanel>
  );
}
