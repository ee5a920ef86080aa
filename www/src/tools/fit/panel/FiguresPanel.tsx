import "#ui/panel/progress.css";
import { computed } from "@preact/signals";
import { fitDocument } from "#document/fit";
import { percent } from "#format/nearness";
import { Button } from "#ui/controls/Button";
import type { FitFigures, Rival } from "#workers/fit/curve";
import fitCss from "../fit.module.css";
import { compareWords, METHODS, roughWords, signed } from "../fit-text";
import { cutting } from "../stage/layers";
import { cancel, collage, fitAgain, rivals, rivalsWhole, shownFigures, shownFit } from "../work/fitting";
import { numbersOf, prepared } from "../work/outline";
import { awaited, cancelled, problem, running } from "../work/progress";
import { source } from "../work/source";
import { Bars, Fact, Table } from "./facts";
import * as messages from "./messages";
import { WithinFigures } from "./WithinPanel";

const model = computed(() => fitDocument.value.model);

/** How near the fit is, and how near others of the same size are. */
export function FiguresPanel() {
  if (cutting.value) return null;
  return (
    <section class="stack" aria-label={messages.accuracy}>
      <div class="section-head">
        <h2>{messages.accuracy}</h2>
        <Progress />
      </div>
      {problem.value !== null && (
        <p class={fitCss["fit-problem"]} role="alert">
          {problem.value}
        </p>
      )}
      {model.value === "closed" ? <Closed /> : model.value === "spline" ? <WithinFigures /> : <Paper />}
    </section>
  );
}

function Progress() {
  const now = running.value;
  if (!now) {
    return cancelled.value ? (
      <Button kind="quiet" icon="reset" onClick={fitAgain}>
        {messages.fitAgain}
      </Button>
    ) : null;
  }
  if (model.value === "collage") return <span class="row-name">{messages.fitting}</span>;
  return (
    <span class={fitCss["fit-progress"]}>
      <progress class="progress" aria-label={messages.fit} max={1} value={now.share} />
      <Button kind="quiet" icon="close" onClick={cancel}>
        {messages.cancel}
      </Button>
    </span>
  );
}

function Closed() {
  const fit = shownFit.value;
  const done = shownFigures.value;
  const current = done && fit && done.curve === fit.curve ? done : null;
  if (!fit) return awaited.value ? <p class="hint">{messages.firstFitWillAppear}</p> : null;
  const { knots, edges } = fit.curve;
  const copies = edges.filter((edge) => edge !== null).length;
  return (
    <>
      {current?.figures ? (
        <>
          <Table figures={current.figures} />
          <p class="hint">{roughWords(current.figures)}</p>
        </>
      ) : current ? (
        <p class="hint">{source.value.kind === "kept" ? messages.thisFitHasNo : messages.measuring}</p>
      ) : null}
      <dl class={`${fitCss["facts"]} number`}>
        <Fact name={messages.numbersName}>{numbersOf(fit.curve)}</Fact>
        <Fact name={messages.knotsName}>{knots.length}</Fact>
        <Fact name={messages.copiedEdges}>{copies}</Fact>
        {current && <Fact name={messages.bytesInLink}>{current.bytes.toLocaleString("en-GB")}</Fact>}
      </dl>
      {current?.figures && <Chart own={current.figures} all={rivals.value} />}
    </>
  );
}

function Paper() {
  const now = collage.value;
  if (!now || now.of !== prepared.value) return null;
  const { fit, options } = now;
  return (
    <>
      <Table figures={fit.figures} />
      <p class="hint">{roughWords(fit.figures)}</p>
      <dl class={`${fitCss["facts"]} number`}>
        <Fact name={messages.numbersName}>{fit.numbers}</Fact>
        <Fact name={messages.mapsName}>{fit.maps.length}</Fact>
        <Fact name={messages.featurePointsName}>{options.features}</Fact>
        <Fact name={messages.widestGapName}>{percent(fit.widest)}</Fact>
      </dl>
    </>
  );
}

/** Errors of the same size as bars, the nearest on top; and in words. */
function Chart({ own, all }: { own: FitFigures; all: readonly Rival[] }) {
  if (all.length === 0) return <p class="hint">{messages.fittingOtherMethodsWith}</p>;
  const rough = ({ fitSlope, outlineSlope }: FitFigures) => signed(fitSlope - outlineSlope);
  return (
    <Bars
      caption={messages.otherMethodsWithSame}
      rows={[
        {
          name: messages.closedCurveFrond,
          about: messages.thisFit,
          rms: own.rms,
          rough: rough(own),
          own: true,
        },
        ...all.map(({ method, figures }) => ({
          ...METHODS[method],
          rms: figures.rms,
          rough: rough(figures),
          own: false,
        })),
      ]}
      words={rivalsWhole.value ? compareWords(own, all) : messages.fittingMore}
    />
  );
}
