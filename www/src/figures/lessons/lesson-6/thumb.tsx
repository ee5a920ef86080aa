import { flagPath, turned } from "./flag";
import flagCss from "./flag.module.css";

/** A letter that turns by quarters. */
export function Thumb() {
  return (
    <svg class={flagCss["flags"]} viewBox="0 0 210 76" aria-hidden="true">
      {[1, 0.5, 0].map((turn, i) => (
        <g key={turn} transform={`translate(${68 * i + 37} 38)`}>
          <circle r={32} class={flagCss["flag-ring"]} />
          <path class={flagCss["flag"]} d={flagPath(turned(Math.PI * turn, 0.5), 48)} />
        </g>
      ))}
    </svg>
  );
}
