import { flagPath, turned } from "./flag";

/** A letter that turns by quarters. */
export function Thumb() {
  return (
    <svg class="flags" viewBox="0 0 210 76" aria-hidden="true">
      {[1, 0.5, 0].map((turn, i) => (
        <g key={turn} transform={`translate(${68 * i + 37} 38)`}>
          <circle r={32} class="flag-ring" />
          <path class="flag" d={flagPath(turned(Math.PI * turn, 0.5), 48)} />
        </g>
      ))}
    </svg>
  );
}
