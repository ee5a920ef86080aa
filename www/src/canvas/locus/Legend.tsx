import { STATE } from "../../engine/breaks";
import { gradient } from "../../style/ramp";
import { decades, type LocusStyle } from "./paint";
import { epsilonWords, partWords } from "./words";

export interface LegendProps {
  /** What there is to be seen: only that is explained. */
  states: ReadonlySet<number>;
  /** Pieces nearer than this count as touching. */
  epsilon: number;
  style: LocusStyle;
}

export function Legend({ states, epsilon, style }: LegendProps) {
  const broken = states.has(STATE.disconnected);
  return (
    <ul class="legend" aria-label="Legend">
      {states.has(STATE.connected) && <Entry box="holds" words="in one piece, proved" />}
      {states.has(STATE.touching) && (
        <Entry box="touches" words={`in one piece, to ${epsilonWords(epsilon)}`} />
      )}
      {broken && style === "yesno" && <Entry box="broken" words="broken" />}
      {states.has(STATE.undecided) && <Entry box="open" words="not decided" />}
      {states.has(STATE.none) && <Entry box="none" words="no shape" />}
      {broken && style === "gap" && <Ramp least={epsilon} />}
    </ul>
  );
}

/** The scale of the gap, with the gaps that have a contour. */
function Ramp({ least }: { least: number }) {
  return (
    <li class="ramp">
      <span>gap</span>
      <span class="ramp-bar">
        <span class="legend-box gap" style={{ backgroundImage: gradient() }} />
        {decades(least).map(({ gap, at }) => (
          <span key={gap} class="ramp-tick" style={{ left: `${100 * at}%` }}>
            {partWords(gap)}
          </span>
        ))}
      </span>
      <span>of the shape</span>
    </li>
  );
}

function Entry({ box, words }: { box: string; words: string }) {
  return (
    <li>
      <span class={`legend-box ${box}`} /> {words}
    </li>
  );
}
