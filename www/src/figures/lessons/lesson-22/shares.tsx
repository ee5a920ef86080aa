import { KE } from "../../fujimoto/deformations/lifted-gasket";
import { shares } from "./answer";
import css from "./shares.module.css";

const UNITS = { width: 300, height: 110, foot: 88, top: 14 };

/** A bar for each level: how much of the lift it has. */
export function Shares({ delta }: { delta: number }) {
  const all = shares(0, delta);
  const step = UNITS.width / all.length;
  const percent = (share: number) => `${Math.round(100 * share)}%`;
  return (
    <svg
      class={css["shares"]}
      viewBox={`0 0 ${UNITS.width} ${UNITS.height}`}
      role="img"
      aria-label={`Shares of the lift by how many letters are turned round, from 0 to ${KE}: ${all.map(percent).join(", ")}`}
    >
      {all.map((share, k) => {
        const tall = share * (UNITS.foot - UNITS.top);
        const x = k * step;
        return (
          <g key={`${k + 1}`}>
            <rect class={css["level-bar"]} x={x + 3} width={step - 6} y={UNITS.foot - tall} height={tall} />
            {share >= 0.005 && (
              <text class={css["share"]} x={x + step / 2} y={UNITS.foot - tall - 3}>
                {percent(share)}
              </text>
            )}
            <text x={x + step / 2} y={UNITS.foot + 14}>
              {k}
            </text>
          </g>
        );
      })}
      <path class={css["foot"]} d={`M0 ${UNITS.foot}H${UNITS.width}`} />
    </svg>
  );
}
