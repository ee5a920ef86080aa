import "#ui/panel/progress.css";
import { computed } from "@preact/signals";
import { fitDocument } from "#document/fit";
import { fixed } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import type { Figures, Rival } from "#workers/fit/curve";
import fitCss from "../fit.module.css";
import { cutting } from "../stage/layers";
import { compareWords, METHODS, percent, roughWords, signed } from "../words";
import {
  cancel,
  cancelled,
  collage,
  fitAgain,
  problem,
  rivals,
  running,
  shownFigures,
  shownFit,
} from "../work/fitting";
import { numbersOf, prepared } from "../work/outline";
import { source } from "../work/source";

const closed = computed(() => fitDocument.value.model === "closed");

/** How near the fit is, and how near others of the same size are. */
export function FiguresPanel() {
  if (cutting.value) return null;
  return (
    <section class="stack" aria-label="How near it is">
      <div class="section-head">
        <h2>How near it is</h2>
        <Progress />
      </div>
      {problem.value !== null && (
        <p class={fitCss["fit-problem"]} role="alert">
          {problem.value}
        </p>
      )}
      {closed.value ? <Closed /> : <Paper />}
    </section>
  );
}

function Progress() {
  const now = running.value;
  if (!now) {
    return cancelled.value ? (
      <Button kind="quiet" icon="reset" onClick={fitAgain}>
        Fit again
      </Button>
    ) : null;
  }
  if (!closed.value) return <span class="row-name">Fitting …</span>;
  return (
    <span class={fitCss["fit-progress"]}>
      <progress class="progress" aria-label="Fit" max={1} value={now.share} />
      <Button kind="quiet" icon="close" onClick={cancel}>
        Cancel
      </Button>
    </span>
  );
}

function Closed() {
  const fit = shownFit.value;
  const done = shownFigures.value;
  const current = done && fit && done.curve === fit.curve ? done : null;
  if (!fit) return <p class="hint">The first fit comes in a moment.</p>;
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
        <p class="hint">
          {source.value.kind === "kept"
            ? "This fit came without the outline that it was made from. Choose the photograph again to see how near it is, or ask for another number: then the curve itself is fitted anew."
            : "It is being measured."}
        </p>
      ) : null}
      <dl class={`${fitCss["facts"]} number`}>
        <Fact name="Numbers">{numbersOf(fit.curve)}</Fact>
        <Fact name="Knots">{knots.length}</Fact>
        <Fact name="Copied edges">{copies}</Fact>
        {current && <Fact name="Bytes in a link">{current.bytes.toLocaleString("en-GB")}</Fact>}
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
        <Fact name="Numbers">{fit.numbers}</Fact>
        <Fact name="Maps">{fit.maps.length}</Fact>
        <Fact name="Feature points">{options.features}</Fact>
        <Fact name="Widest gap">{percent(fit.widest)}</Fact>
      </dl>
    </>
  );
}

function Fact({ name, children }: { name: string; children: string | number }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{children}</dd>
    </div>
  );
}

function Table({ figures }: { figures: Figures }) {
  const { rms, hausdorff, lengthRatio, fitSlope, outlineSlope } = figures;
  return (
    <dl class={`${fitCss["facts"]} number`} data-testid="figures">
      <div title="Root mean square distance from the outline to the fit, in percent of the diagonal of its box">
        <dt>Error (RMS)</dt>
        <dd data-testid="rms">{percent(rms)}</dd>
      </div>
      <div title="No point of the outline or of the fit is farther from the other">
        <dt>Farthest (Hausdorff)</dt>
        <dd>{percent(hausdorff)}</dd>
      </div>
      <div title="The fit's length over the outline's">
        <dt>Length</dt>
        <dd>{`${fixed(100 * lengthRatio, 1)}%`}</dd>
      </div>
      <div title="Box dimension between 1/64 and 1/256 of the diagonal: leaf, fit, and the difference dD">
        <dt>
          Dimension <span class="symbol">D</span>
        </dt>
        <dd>{`${fixed(outlineSlope, 3)} / ${fixed(fitSlope, 3)} (${signed(fitSlope - outlineSlope)})`}</dd>
      </div>
    </dl>
  );
}

/** Errors of the same size as bars, the nearest on top; and in words. */
function Chart({ own, all }: { own: Figures; all: readonly Rival[] }) {
  if (all.length === 0) return <p class="hint">Others of the same size are being fitted …</p>;
  const rows = [
    { name: "Closed curve (Frond)", about: "This fit", figures: own, own: true },
    ...all.map(({ method, figures }) => ({ ...METHODS[method], figures, own: false })),
  ].sort((a, b) => a.figures.rms - b.figures.rms);
  const most = Math.max(...rows.map((row) => row.figures.rms));
  return (
    <div class={fitCss["chart"]}>
      <table class="number" data-testid="chart">
        <caption>Error of as many numbers, spent in other ways</caption>
        <thead>
          <tr>
            <th scope="col">Way</th>
            <th scope="col">RMS</th>
            <th scope="col" title="Difference in box dimension">
              dD
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <tr key={row.name} class={row.own ? fitCss["own"] : ""} title={row.about}>
              <th scope="row">
                {row.name}
                <span
                  class={fitCss["bar"]}
                  aria-hidden="true"
                  style={{ "--share": String(row.figures.rms / most) }}
                />
              </th>
              <td>{percent(row.figures.rms)}</td>
              <td>{signed(row.figures.fitSlope - row.figures.outlineSlope)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p class="hint" data-testid="compare">
        {compareWords(own, all)}
      </p>
    </div>
  );
}
