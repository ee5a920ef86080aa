/** What is told of a fit, in rows and bars. */

import { percent } from "#format/nearness";
import { fixed } from "#format/numbers";
import type { FitFigures } from "#workers/fit/curve";
import fitCss from "../fit.module.css";
import { signed } from "../fit-text";
import * as messages from "./messages";

export function Fact({ name, children }: { name: string; children: string | number }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{children}</dd>
    </div>
  );
}

export function Table({ figures }: { figures: FitFigures }) {
  const { rms, hausdorff, lengthRatio, fitSlope, outlineSlope } = figures;
  return (
    <dl class={`${fitCss["facts"]} number`} data-testid="figures">
      <div title={messages.rootMeanSquareDistance}>
        <dt>{messages.errorRms}</dt>
        <dd data-testid="rms">{percent(rms)}</dd>
      </div>
      <div title={messages.noPointOutlineOr}>
        <dt>{messages.largestDistanceHausdorff}</dt>
        <dd>{percent(hausdorff)}</dd>
      </div>
      <div title={messages.perimeterFitDividedBy}>
        <dt>{messages.perimeter}</dt>
        <dd>{`${fixed(100 * lengthRatio, 1)}%`}</dd>
      </div>
      <div title={messages.boxDimensionBetween1}>
        <dt>
          {messages.dimension} <span class="symbol">D</span>
        </dt>
        <dd>{`${fixed(outlineSlope, 3)} / ${fixed(fitSlope, 3)} (${signed(fitSlope - outlineSlope)})`}</dd>
      </div>
    </dl>
  );
}

export interface Bar {
  name: string;
  about: string;
  rms: number;
  /** Difference in box dimension, where that is told. */
  rough?: string;
  own: boolean;
}

/** Errors as bars, the nearest on top; and in words. */
export function Bars({ caption, rows, words }: { caption: string; rows: readonly Bar[]; words: string }) {
  const sorted = [...rows].sort((a, b) => a.rms - b.rms);
  const most = Math.max(...rows.map((row) => row.rms));
  const rough = rows.some((row) => row.rough !== undefined);
  return (
    <div class={fitCss["chart"]}>
      <table class="number" data-testid="chart">
        <caption>{caption}</caption>
        <thead>
          <tr>
            <th scope="col">{messages.method}</th>
            <th scope="col">{messages.rms}</th>
            {rough && (
              <th scope="col" title={messages.differenceInBoxDimension}>
                dD
              </th>
            )}
          </tr>
        </thead>
        <tbody>
          {sorted.map((row) => (
            <tr key={row.name} class={row.own ? fitCss["own"] : ""} title={row.about}>
              <th scope="row">
                {row.name}
                <span
                  class={fitCss["bar"]}
                  aria-hidden="true"
                  style={{ "--share": String(most > 0 ? row.rms / most : 0) }}
                />
              </th>
              <td>{percent(row.rms)}</td>
              {rough && <td>{row.rough}</td>}
            </tr>
          ))}
        </tbody>
      </table>
      <p class="hint" data-testid="compare">
        {words}
      </p>
    </div>
  );
}
