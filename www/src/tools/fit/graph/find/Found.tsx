import { signal } from "@preact/signals";
import { formatNumber } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { SliderField } from "#ui/controls/SliderField";
import { Switch } from "#ui/controls/Switch";
import type { HoughCluster } from "#workers/fit/hough";
import graphCss from "../graph.module.css";
import * as messages from "../messages";
import { graph } from "../model/document";
import {
  aboutOf,
  axisWords,
  costWords,
  countWords,
  errorWords,
  mapWords,
  nameOf,
  offWords,
  spreadWords,
} from "../model/graph-text";
import { DomainFields } from "../Pieces";
import { type AxesId, ClusterPlot } from "./ClusterPlot";
import {
  assemble,
  assembled,
  assembling,
  choose,
  chosen,
  copying,
  current,
  found,
  isPicked,
  LEAST_TOLERANCE,
  live,
  MOST_TOLERANCE,
  mapOf,
  picks,
  running,
  search,
  setDomain,
  tableThree,
  tied,
  togglePick,
  tolerance,
} from "./search";

/** As many are seen at first. */
const SEEN_AT_FIRST = 8;
const all = signal(false);

/** The clusters by hits, with their names, how well they hold, and whether they are picked. */
function CandidateList() {
  const list = found.value;
  if (list.length === 0) return null;
  const shown = list
    .map((cluster, index) => ({ cluster, index }))
    .filter(({ index }) => all.value || index < SEEN_AT_FIRST || isPicked(index) || index === chosen.value);
  return (
    <div class="stack">
      <ul aria-label={messages.candidatesMostHitsFirst}>
        {shown.map(({ cluster, index }) => (
          <Row key={index} cluster={cluster} index={index} />
        ))}
      </ul>
      {list.length > SEEN_AT_FIRST && (
        <Button
          kind="quiet"
          onClick={() => {
            all.value = !all.peek();
          }}
        >
          {all.value ? messages.fewer : messages.allOf(list.length)}
        </Button>
      )}
    </div>
  );
}

function Row({ cluster, index }: { cluster: HoughCluster; index: number }) {
  const open = chosen.value === index;
  const name = nameOf(cluster, index);
  return (
    <li class={`${graphCss["candidate"]} ${open ? graphCss["open"] : ""}`}>
      <input
        type="checkbox"
        aria-label={messages.pick(name)}
        checked={isPicked(index)}
        onChange={() => togglePick(index)}
      />
      <button
        type="button"
        class={graphCss["candidate-name"]}
        aria-expanded={open}
        title={aboutOf(cluster)}
        onClick={() => choose(index)}
      >
        <span>{name}</span>
        <span class="dim number">{errorWords(cluster)}</span>
        <span class="dim number">{countWords(cluster.hits)}</span>
      </button>
      {open && (
        <div class={graphCss["candidate-more"]}>
          <p class="hint">{aboutOf(cluster)}</p>
          <p class="number">
            {mapWords(picks.value.find((one) => one.cluster === index)?.map ?? mapOf(cluster))}
          </p>
          {isPicked(index) && <Domain index={index} />}
        </div>
      )}
    </li>
  );
}

/** The part that a picked map copies. */
function Domain({ index }: { index: number }) {
  const pick = picks.value.find((one) => one.cluster === index);
  const fine = search.value?.sets.fine;
  if (!pick || !fine) return null;
  const [from, to] = [fine[0] ?? 0, fine[fine.length - 2] ?? 1];
  return (
    <DomainFields
      domain={pick.domain}
      within={[from, to]}
      onChange={(end, t) => {
        const domain: [number, number] = [...pick.domain];
        domain[end] = t;
        if (domain[0] >= domain[1]) return messages.partMustStartBefore;
        setDomain(index, domain);
        return undefined;
      }}
    />
  );
}

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
