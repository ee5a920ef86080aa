import { resolutionWords, shareWords, toldOf, verdictWords } from "#format/verdict";
import { STATE } from "#geometry/states";
import { gradient } from "#style/ramp";
import { Term } from "#ui/terms/Term";
import type { TermName } from "#ui/terms/words";
import * as messages from "../messages";
import css from "./locus.module.css";
import { decades, type LocusStyle } from "./paint";

interface LegendProps {
  /** What there is to be seen: only that is explained. */
  states: ReadonlySet<number>;
  /** Pieces nearer than this count as touching. */
  epsilon: number;
  style: LocusStyle;
  /** The part of what holds that is proved, in [0, 1]; null where nothing holds. */
  proved?: number | null;
}

export function Legend({ states, epsilon, style, proved = null }: LegendProps) {
  const broken = states.has(STATE.disconnected);
  return (
    <ul class={css["legend"]} aria-label={messages.legend}>
      {BOXES.filter(([state]) => states.has(state)).map(([state, box]) => (
        <Entry
          key={state}
          box={box}
          words={state === STATE.connected ? provedWords(proved) : wordsOf(state, epsilon)}
          term={TERMS[state]}
        />
      ))}
      {broken && style === "yesno" && <Entry box="broken" words={APART} />}
      {broken && style === "gap" && <Ramp least={epsilon} />}
    </ul>
  );
}

const BOXES = [
  [STATE.connected, "holds"],
  [STATE.touching, "touches"],
  [STATE.hidden, "hidden"],
  [STATE.undecided, "open"],
  [STATE.none, "none"],
] as const;

const TERMS: Readonly<Record<number, TermName>> = {
  [STATE.connected]: "proved",
  [STATE.touching]: messages.noGapSeen,
  [STATE.hidden]: "gap",
};

const lowered = (words: string) => words.charAt(0).toLowerCase() + words.slice(1);
const textOf = (state: number, epsilon?: number) => lowered(verdictWords(toldOf(state, 1), epsilon).text);
const APART = textOf(STATE.disconnected);

function wordsOf(state: number, epsilon: number): string {
  if (state === STATE.hidden) return messages.apartUnder(APART, resolutionWords(epsilon));
  if (state === STATE.touching) return messages.noGapTo(textOf(state, epsilon), resolutionWords(epsilon));
  return textOf(state, epsilon);
}

/** All is only said where all is. */
function provedWords(part: number | null): string {
  const words = textOf(STATE.connected);
  return part === null || part === 1 ? words : messages.partOfPale(words, Math.floor(100 * part));
}

/** The scale of the gap, with the gaps that have a contour. */
function Ramp({ least }: { least: number }) {
  return (
    <li class={css["ramp"]}>
      <span>
        <Term name="gap">{messages.apartGap(APART)}</Term>
      </span>
      <span class={css["ramp-bar"]}>
        <span class={`${css["legend-box"]} gap`} style={{ backgroundImage: gradient() }} />
        {decades(least).map(({ gap, at }) => (
          <span key={gap} class={css["ramp-tick"]} style={{ left: `${100 * at}%` }}>
            {shareWords(gap)}
          </span>
        ))}
      </span>
      <span>{messages.ofItsSize}</span>
    </li>
  );
}

function Entry({ box, words, term }: { box: string; words: string; term?: TermName | undefined }) {
  return (
    <li>
      <span class={`${css["legend-box"]} ${box}`} /> {term ? <Term name={term}>{words}</Term> : words}
    </li>
  );
}
