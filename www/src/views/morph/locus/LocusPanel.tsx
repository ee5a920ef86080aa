import "./locus.css";
import { computed, signal } from "@preact/signals";
import { STATE } from "../../../engine/breaks";
import { locus } from "../../../engine/results";
import { uv } from "../../../state/morph";
import { gradient } from "../../../style/ramp";
import { fixed } from "../../../ui/number";
import { Segmented } from "../../../ui/Segmented";
import { LocusSquare } from "./LocusSquare";
import type { LocusStyle } from "./paint";
import { bounds } from "./way";

/** How the field is shown: a way of looking, no part of the document. */
const style = signal<LocusStyle>("gap");

/** Where the morph holds together: all of (u, v), with the path through it. */
export function LocusPanel() {
  return (
    <section class="locus" aria-labelledby="locus-title">
      <header class="section-head">
        <h2 id="locus-title">Where it holds together</h2>
        <Segmented
          label="How to show it"
          value={style.value}
          onChange={(next) => {
            style.value = next;
          }}
          options={[
            { value: "gap", label: "Gap", description: "How wide the widest gap between the pieces is" },
            { value: "yesno", label: "Yes / no", description: "Only whether it holds together" },
          ]}
        />
      </header>
      <div class="locus-plot">
        <Ticks axis="v" />
        <LocusSquare style={style.value} />
        <Ticks axis="u" />
      </div>
      <Legend style={style.value} />
      <Now />
    </section>
  );
}

/** Where the picture is now, in numbers. */
function Now() {
  const [u, v] = uv.value;
  return (
    <dl class="locus-now">
      <div>
        <dt>turn and stretch</dt>
        <dd>
          <span class="symbol">u</span> <output>{fixed(u)}</output>
        </dd>
      </div>
      <div>
        <dt>move</dt>
        <dd>
          <span class="symbol">v</span> <output>{fixed(v)}</output>
        </dd>
      </div>
    </dl>
  );
}

/** The whole numbers along one side; 0 is the first shape, 1 the last. */
function Ticks({ axis }: { axis: "u" | "v" }) {
  const { u0, u1, v0, v1 } = bounds.value;
  const [low, high] = axis === "u" ? [u0, u1] : [v0, v1];
  const ticks = [];
  for (let at = Math.ceil(low); at <= high; at++) ticks.push(at);
  return (
    <div class={`locus-ticks ${axis}`} aria-hidden="true">
      {ticks.map((at) => (
        <span key={at} style={{ "--at": `${(100 * (at - low)) / (high - low)}%` }}>
          {fixed(at, 0)}
        </span>
      ))}
      <em>{axis}</em>
    </div>
  );
}

/** What there is to explain besides whole and broken. */
const rare = computed(() => {
  const state = locus.value?.state;
  return { none: state?.includes(STATE.none) === true, open: state?.includes(STATE.undecided) === true };
});

function Legend({ style: shown }: { style: LocusStyle }) {
  const { none, open } = rare.value;
  return (
    <ul class="legend" aria-label="Legend">
      <Entry box="holds" words="in one piece" />
      {shown === "gap" ? (
        <Entry box="gap" words="gap" image={gradient()} />
      ) : (
        <Entry box="broken" words="broken" />
      )}
      {none && <Entry box="none" words="no shape" />}
      {open && <Entry box="open" words="not decided" />}
    </ul>
  );
}

function Entry({ box, words, image }: { box: string; words: string; image?: string }) {
  return (
    <li>
      <span class={`legend-box ${box}`} style={image === undefined ? {} : { backgroundImage: image }} />{" "}
      {words}
    </li>
  );
}
