import type { LocusResult } from "#compute/results";
import { fixed } from "#format/numbers";
import type { Uv } from "#geometry/path";
import layout from "../../kit/frame/layout.module.css";
import { PointControls } from "../../kit/frame/point-controls";
import { Plane } from "../../kit/locus/locus-square";
import { BOUNDS, type Complex, DUST, WHOLE } from "../../kit/locus/set-m";
import css from "./disc.module.css";

/** "0.400 + 0.500i" */
export function complexWords([re, im]: Complex): string {
  return `${fixed(re, 3)} ${im < 0 ? "−" : "+"} ${fixed(Math.abs(im), 3)}i`;
}

interface DiscProps {
  field: LocusResult | null;
  s: Complex;
  shown: boolean;
  onMove: (s: Uv) => void;
}

/** The plane of s with its two circles, and M on it once it is shown. */
export function Disc({ field, s, shown, onMove }: DiscProps) {
  return (
    <Plane
      field={field}
      bounds={BOUNDS}
      point={s}
      onMove={onMove}
      plain
      label={
        shown
          ? `The set M, symmetric on four sides, ragged between the circles of size one half and 0.7071, with spikes along the real line; s is at ${complexWords(s)}.`
          : `The plane of s with two circles, of size one half and 0.7071; s is at ${complexWords(s)}.`
      }
    >
      {(place) => {
        const [x, y] = place([0, 0]);
        return (
          <g class={`${css["disc"]} ${shown ? css["shown"] : ""}`}>
            {!shown && <path class={css["disc-axis"]} d={`M0 ${y}H300M${x} 0V300`} />}
            {[DUST, WHOLE].map((size) => (
              <g key={size}>
                <circle cx={x} cy={y} r={place([size, 0])[0] - x} />
                {!shown && (
                  <text x={x + 4} y={place([0, -size])[1] - 4}>
                    {size === DUST ? "½" : "0.7071"}
                  </text>
                )}
              </g>
            ))}
            {!shown && (
              <text x={x} y={y - 6} text-anchor="middle">
                dust
              </text>
            )}
          </g>
        );
      }}
    </Plane>
  );
}

const PARTS = [
  { label: "real part of", symbol: "s", name: "Real part of s" },
  { label: "imaginary part of", symbol: "s", name: "Imaginary part of s" },
] as const;

/** Both parts of s, for keys and for those who would rather not aim. */
export function Sliders({ s, onMove }: { s: Complex; onMove: (s: Uv) => void }) {
  return (
    <div class={layout["controls"]}>
      <PointControls
        axes={PARTS}
        range={[-0.74, 0.74]}
        point={s}
        said={() => complexWords(s)}
        onMove={onMove}
      />
    </div>
  );
}
