import { signal } from "@preact/signals";
import { formatNumber } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { SliderField } from "#ui/controls/SliderField";
import { Switch } from "#ui/controls/Switch";
import graphCss from "../graph.module.css";
import { graph } from "../model/document";
import { axisWords, costWords, countWords, offWords, spreadWords } from "../model/words";
import { CandidateList } from "./Candidates";
import { type AxesId, ClusterPlot } from "./ClusterPlot";
import {
  assemble,
  assembled,
  assembling,
  copying,
  current,
  found,
  LEAST_TOLERANCE,
  live,
  MOST_TOLERANCE,
  picks,
  running,
  search,
  tableThree,
  tied,
  tolerance,
} from "./search";

const axes = signal<AxesId>("ac");

/** What the votes say, and what is made of it. */
export function FoundSection() {
  const now = search.value;
  const counting = live.value;
  if (!counting && (!now || !current.value)) return null;
  return (
    <section class="stack">
      <div class="section-head">
        <h2>Clusters of votes</h2>
        {now && !running.value && (
          <span class="hint number" data-part="took" data-ms={Math.round(now.took)}>
            {countWords(now.votes)} votes, {formatNumber(now.took / 1000, 1)} s
          </span>
        )}
      </div>
      <Segmented<AxesId>
        label="What the picture shows"
        options={[
          {
            value: "ac",
            label: "Scales a and c",
            description: "How much copies shrink sideways and upwards",
          },
          {
            value: "principal",
            label: "Main directions",
            description: "The two directions in which clusters spread most, of all five",
          },
        ]}
        value={axes.value}
        onChange={(next) => {
          axes.value = next;
        }}
      />
      <ClusterPlot axes={counting ? "ac" : axes.value} />
      {now && current.value && !running.value && (
        <>
          <Directions />
          <CandidateList />
          <Assembly />
        </>
      )}
    </section>
  );
}

function Directions() {
  const space = search.value?.clusters.space;
  if (!space)
    return <p class="hint">No map got more than a few votes. Try other feature points, or smoothing.</p>;
  return (
    <p class="hint">
      {spreadWords(space)}{" "}
      {axes.value === "principal" && (
        <>
          Across: {axisWords(space.axes[0] ?? [])}; up: {axisWords(space.axes[1] ?? [])}.
        </>
      )}
    </p>
  );
}

/** From candidates to a whole function. */
function Assembly() {
  const seven = search.value?.of.example === "hidden" ? tableThree(found.value) : [];
  const done = assembled.value;
  const picked = picks.value.length;
  return (
    <div class={graphCss["graph-assembly"]}>
      <Switch
        checked={copying.value}
        onChange={(on) => {
          copying.value = on;
        }}
        description="The feature points of the copied part, and where the map takes them"
      >
        Show the chosen map on the graph
      </Switch>
      <SliderField
        label="Nowhere farther off than"
        unit="%"
        ends={["0.1% of the height", "20%"]}
        value={100 * tolerance.value}
        min={Math.log10(100 * LEAST_TOLERANCE)}
        max={Math.log10(100 * MOST_TOLERANCE)}
        step={0.01}
        digits={2}
        scale={{ to: Math.log10, from: (at) => Number((10 ** at).toPrecision(2)) }}
        field={{ min: 100 * LEAST_TOLERANCE, max: 100 * MOST_TOLERANCE, step: 0.1 }}
        words={`${formatNumber(100 * tolerance.value, 2)} percent of the height`}
        onChange={(next) => {
          tolerance.value = next / 100;
        }}
      />
      <div class="row">
        <Button
          kind="primary"
          disabled={assembling.value || found.value.length === 0}
          onClick={() => void assemble("itself")}
        >
          Assemble
        </Button>
        <Button disabled={assembling.value || picked === 0} onClick={() => void assemble("hand")}>
          {picked === 0 ? "Assemble picks" : `Assemble ${picked} ${picked === 1 ? "pick" : "picks"}`}
        </Button>
      </div>
      {picked > 0 && (
        <Switch
          checked={tied.value}
          onChange={(on) => {
            tied.value = on;
          }}
          description="Off: maps stay as they are, as in the paper, and pieces may leave gaps."
        >
          Let pieces meet
        </Switch>
      )}
      {seven.length > 0 && (
        <Button
          kind="quiet"
          description="The maps that the authors picked by hand, refined as they did, with their domains"
          onClick={() => {
            picks.value = seven;
          }}
        >
          {`Pick those of Table 3 (${seven.length} of 7 found)`}
        </Button>
      )}
      {done && done.graph === graph.value && (
        <p class="hint" data-part="assembled">
          {done.graph.kind.toUpperCase()} of {done.graph.pieces.length} pieces: {offWords(done)}.{" "}
          {costWords(done)}
        </p>
      )}
    </div>
  );
}
