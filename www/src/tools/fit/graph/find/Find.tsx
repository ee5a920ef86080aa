import { formatNumber } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { Select } from "#ui/controls/Select";
import { Slider } from "#ui/controls/Slider";
import { Switch } from "#ui/controls/Switch";
import { FileButton } from "#ui/files/FileButton";
import graphCss from "../graph.module.css";
import * as messages from "../messages";
import { EXAMPLES } from "../model/examples";
import { countWords, phaseWords } from "../model/graph-text";
import {
  COUNTS,
  type CountId,
  counts,
  fileProblem,
  MOST_SMOOTHING,
  reading,
  series,
  smoothing,
  takeExample,
  takeFile,
} from "../model/series";
import { cancel, featuresChanged, find, problem, reflected, running } from "./search";

/** What is measured, and the search for its maps. */
export function FindSection() {
  const now = series.value;
  return (
    <section class="stack" aria-label={messages.findMapsSeries}>
      <div class="section-head">
        <h2>{messages.findMapsSeries}</h2>
      </div>
      {now ? (
        <p class={graphCss["graph-source"]}>
          <strong>{now.name}</strong>{" "}
          <span class="dim number">{messages.points(countWords(now.points.length / 2))}</span>
        </p>
      ) : (
        <p class="hint">{messages.dropTableNumbersHere}</p>
      )}
      <FileRow />
      {fileProblem.value !== null && (
        <p class="field-problem" role="alert">
          {fileProblem.value}
        </p>
      )}
      {now && <Options />}
    </section>
  );
}

function FileRow() {
  const example = series.value?.example ?? "";
  return (
    <div class={`row ${graphCss["graph-files"]}`}>
      <FileButton
        label={messages.tableNumbers}
        accept=".csv,.tsv,.txt,.dat,.json,.geojson,text/csv,text/plain"
        disabled={reading.value !== null}
        onFile={(file) => void takeFile(file)}
      >
        {reading.value === null ? messages.openTable : messages.reading}
      </FileButton>
      <Select
        aria-label={messages.example}
        value={example}
        onChange={(event) => takeExample(event.currentTarget.value)}
      >
        <option value="" disabled>
          {messages.orExample}
        </option>
        {EXAMPLES.map(({ id, name }) => (
          <option key={id} value={id}>
            {name}
          </option>
        ))}
      </Select>
    </div>
  );
}

function Options() {
  const busy = running.value;
  const example = EXAMPLES.find(({ id }) => id === series.value?.example);
  return (
    <>
      {example && <p class="hint">{example.about}</p>}
      <p class="row-name">{messages.featurePointsCoarseAnd}</p>
      <Segmented<CountId>
        label={messages.featurePointsCoarseAnd}
        options={COUNTS.map(({ id, label, description }) => ({ value: id, label, description }))}
        value={counts.value}
        onChange={(id) => {
          counts.value = id;
          featuresChanged();
        }}
      />
      <div class={graphCss["graph-slider"]}>
        <span class="row-name">{messages.smoothingAgainstNoise}</span>
        <span class="number dim">
          {smoothing.value === 0 ? messages.none : `${formatNumber(100 * smoothing.value, 2)}%`}
        </span>
        <Slider
          label={messages.smoothingAgainstNoise}
          value={smoothing.value}
          max={MOST_SMOOTHING}
          step={0.0005}
          valueText={
            smoothing.value === 0
              ? messages.none
              : messages.percentOfLength(formatNumber(100 * smoothing.value, 2))
          }
          onChange={(next) => {
            smoothing.value = Number(next.toFixed(4));
          }}
          onDone={featuresChanged}
        />
      </div>
      <Switch
        checked={reflected.value}
        onChange={(on) => {
          reflected.value = on;
        }}
        description={messages.alsoFindsCopiesRun}
      >
        {messages.includeMirroredCopies}
      </Switch>
      {busy === null ? (
        <Button kind="primary" onClick={() => void find()}>
          {messages.findMaps}
        </Button>
      ) : (
        <div class={graphCss["graph-busy"]}>
          <progress value={busy.share} max={1} aria-label={messages.search} />
          <p class="number">{messages.phaseVotes(phaseWords(busy.phase), countWords(busy.votes))}</p>
          <Button onClick={cancel}>{messages.stop}</Button>
        </div>
      )}
      {problem.value !== null && (
        <p class="field-problem" role="alert">
          {problem.value}
        </p>
      )}
    </>
  );
}
