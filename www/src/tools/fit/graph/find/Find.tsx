import { formatNumber } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { Select } from "#ui/controls/Select";
import { Slider } from "#ui/controls/Slider";
import { Switch } from "#ui/controls/Switch";
import { FileButton } from "#ui/files/FileButton";
import graphCss from "../graph.module.css";
import { EXAMPLES } from "../model/examples";
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
import { countWords, phaseWords } from "../model/words";
import { cancel, featuresChanged, find, problem, reflected, running } from "./search";

/** What is measured, and the search for its maps. */
export function FindSection() {
  const now = series.value;
  return (
    <section class="stack" aria-label="Find the maps of a series">
      <div class="section-head">
        <h2>Find the maps of a series</h2>
      </div>
      {now ? (
        <p class={graphCss["graph-source"]}>
          <strong>{now.name}</strong>{" "}
          <span class="dim number">{countWords(now.points.length / 2)} points</span>
        </p>
      ) : (
        <p class="hint">
          Drop a table of numbers here: a time series or the heights of a mountain. Frond looks for the
          smaller copies that it is made of.
        </p>
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
        label="A table of numbers"
        accept=".csv,.tsv,.txt,.dat,.json,.geojson,text/csv,text/plain"
        disabled={reading.value !== null}
        onFile={(file) => void takeFile(file)}
      >
        {reading.value === null ? "Open a table …" : "Reading …"}
      </FileButton>
      <Select
        aria-label="An example"
        value={example}
        onChange={(event) => takeExample(event.currentTarget.value)}
      >
        <option value="" disabled>
          Or an example …
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
      <p class="row-name">Feature points, coarse and fine</p>
      <Segmented<CountId>
        label="Feature points, coarse and fine"
        options={COUNTS.map(({ id, label, description }) => ({ value: id, label, description }))}
        value={counts.value}
        onChange={(id) => {
          counts.value = id;
          featuresChanged();
        }}
      />
      <div class={graphCss["graph-slider"]}>
        <span class="row-name">Smoothing, against noise</span>
        <span class="number dim">
          {smoothing.value === 0 ? "none" : `${formatNumber(100 * smoothing.value, 2)}%`}
        </span>
        <Slider
          label="Smoothing, against noise"
          value={smoothing.value}
          max={MOST_SMOOTHING}
          step={0.0005}
          valueText={
            smoothing.value === 0 ? "none" : `${formatNumber(100 * smoothing.value, 2)} percent of the length`
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
        description="Copies that run backwards are looked for, too. It takes twice as long."
      >
        Mirrored copies, too
      </Switch>
      {busy === null ? (
        <Button kind="primary" onClick={() => void find()}>
          Find the maps
        </Button>
      ) : (
        <div class={graphCss["graph-busy"]}>
          <progress value={busy.share} max={1} aria-label="Search" />
          <p class="number">
            {phaseWords(busy.phase)}: {countWords(busy.votes)} votes
          </p>
          <Button onClick={cancel}>Stop</Button>
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
