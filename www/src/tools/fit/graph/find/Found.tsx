import { signal } from "@preact/signals";
import { formatNumber } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { SliderField } from "#ui/controls/SliderField";
import { Switch } from "#ui/controls/Switch";
import graphCss from "../graph.module.css";
import * as messages from "../messages";
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
        <h2>{messages.clustersVotes}</h2>
        {now && !running.value && (
          <span class="hint number" data-part="took" data-ms={Math.round(now.took)}>
            {messages.votesTook(countWords(now.votes), formatNumber(now.took / 1000, 1))}
          </span>
        )}
      </div>
      <Segmented<AxesId>
        label={messages.plot}
        options={[
          {
            value: "ac",
            label: messages.scalesAndC,
            description: messages.howMuchCopiesShrink,
          },
          {
            value: "principal",
            label: messages.mainDirections,
            description: messages.twoFiveDirectionsIn,
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
  if (!space) return <p class="hint">{messages.noMapGotMore}</p>;
  return (
    <p class="hint">
      {spreadWords(space)}{" "}
      {axes.value === "principal" &&
        messages.plotAxes(axisWords(space.axes[0] ?? []), axisWords(space.axes[1] ?? []))}
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
        description={messages.featurePointsCopiedPart}
      >
        {messages.showSelectedMapOn}
      </Switch>
      <SliderField
        label={messages.maximumError}
        unit="%"
        ends={[messages.n01Height, "20%"]}
        value={100 * tolerance.value}
        min={Math.log10(100 * LEAST_TOLERANCE)}
        max={Math.log10(100 * MOST_TOLERANCE)}
        step={0.01}
        digits={2}
        scale={{ to: Math.log10, from: (at) => Number((10 ** at).toPrecision(2)) }}
        field={{ min: 100 * LEAST_TOLERANCE, max: 100 * MOST_TOLERANCE, step: 0.1 }}
        words={messages.percentOfHeight(formatNumber(100 * tolerance.value, 2))}
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
          {messages.assemble}
        </Button>
        <Button disabled={assembling.value || picked === 0} onClick={() => void assemble("hand")}>
          {picked === 0 ? messages.assembleSelection : messages.assembleOf(picked)}
        </Button>
      </div>
      {picked > 0 && (
        <Switch
          checked={tied.value}
          onChange={(on) => {
            tied.value = on;
          }}
          description={messages.offMapsKeepTheir}
        >
          {messages.closeGapsBetweenPieces}
        </Switch>
      )}
      {seven.length > 0 && (
        <Button
          kind="quiet"
          description={messages.mapsAuthorsSelectedBy}
          onClick={() => {
            picks.value = seven;
          }}
        >
          {messages.pickTable3(seven.length)}
        </Button>
      )}
      {done && done.graph === graph.value && (
        <p class="hint" data-part="assembled">
          {messages.assembledOf(
            done.graph.kind.toUpperCase(),
            done.graph.pieces.length,
            offWords(done),
            costWords(done),
          )}
        </p>
      )}
    </div>
  );
}
