import type { ComponentChildren } from "preact";
import { BOUNDS } from "#compute/locus/job";
import type { LocusResult } from "#compute/results";
import { resolutionWords } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { gradient } from "#style/ramp";
import { VerdictSign } from "#ui/shapes/VerdictSign";
import { Plane } from "../../kit/locus/locus-square";
import css from "./chart.module.css";
import { MARKED, type Touch, unproved } from "./map";

interface ChartProps {
  /** What is known of it; null: it is covered. */
  field: LocusResult | null;
  label: string | null;
  /** Marks that were left by touching. */
  touches?: readonly Touch[];
  /** Whether the three places of the question are on it. */
  marked?: boolean;
  point?: Uv;
  onMove?: (point: Uv) => void;
  children?: (place: (point: Uv) => [left: number, top: number]) => ComponentChildren;
}

/** The map of shapes, covered or not, with what is marked on it. */
export function Chart({ field, label, touches = [], marked = false, children, ...point }: ChartProps) {
  return (
    <Plane field={field} label={field ? label : null} bounds={BOUNDS} plain={field === null} {...point}>
      {(place) => (
        <>
          {field && (
            <path
              class={css["unproved"]}
              d={unproved(field)
                .map((at) => `M${place(at).join(" ")}h0`)
                .join("")}
            />
          )}
          <path class={css["straight"]} d={`M${place([0, 0]).join(" ")}L${place([1, 1]).join(" ")}`} />
          {touches.map(({ at, mark }) => {
            const [x, y] = place(at);
            return (
              <g key={at.join()} transform={`translate(${x - 8} ${y - 8})`}>
                <VerdictSign tone={mark} />
              </g>
            );
          })}
          {marked && MARKED.map(({ name, at }) => <Named key={name} name={name} at={place(at)} />)}
          <Named name="A" at={place([0, 0])} />
          <Named name="B" at={place([1, 1])} />
          {children?.(place)}
        </>
      )}
    </Plane>
  );
}

/** A letter or a number at its place. */
function Named({ name, at: [x, y] }: { name: string; at: [number, number] }) {
  return (
    <g class={css["named"]} transform={`translate(${x} ${y})`}>
      <circle r={7} />
      <text dy="0.35em" text-anchor="middle">
        {name}
      </text>
    </g>
  );
}

/** What the colours of the map say. */
export function Legend({ epsilon }: { epsilon: number }) {
  return (
    <ul class={css["legend"]} aria-label="Legend">
      <li>
        <span class={css["box"]} /> in one piece, proved
      </li>
      <li>
        <span class={`${css["box"]} ${css["dotted"]}`} /> with a dot: no gap seen at{" "}
        {resolutionWords(epsilon)}, and nothing is proved
      </li>
      <li>
        <span class={`${css["box"]} ${css["wide"]}`} style={{ backgroundImage: gradient() }} /> in pieces,
        proved; the darker, the wider the gap
      </li>
      <li>
        <span class={`${css["box"]} ${css["open"]}`} /> grey: not decided
      </li>
    </ul>
  );
}
