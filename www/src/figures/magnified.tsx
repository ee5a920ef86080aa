import { useMemo } from "preact/hooks";
import type { Bend, Colouring, MapRow } from "../engine/api";
import type { Box } from "../state/fit";
import { fixed } from "../ui/number";
import type { Point } from "./apart";
import { Bent } from "./bent";
import type { Place } from "./drawn";

/** A part that is shown larger: its middle and its width. It is as high as it is wide. */
export interface Lens {
  number: number;
  kind: "red" | "blue" | "green" | "black";
  about: string;
  x: number;
  y: number;
  width: number;
}

export interface MagnifiedProps {
  /** The panel that is magnified. */
  name: string;
  maps: MapRow[];
  bend: Bend;
  box: Box;
  aspect: number;
  colouring?: Colouring;
  lenses: readonly Lens[];
}

/** A bent shape with frames on it, and what is in the frames. */
export function Magnified({ name, maps, bend, box, aspect, colouring = "map", lenses }: MagnifiedProps) {
  return (
    <div class="magnified">
      <figure class="panel">
        <Bent
          maps={maps}
          bend={bend}
          box={box}
          aspect={aspect}
          colouring={colouring}
          grid={0}
          label={`${name} again, with frames round three parts`}
        >
          {(place) => lenses.map((lens) => <Framed key={lens.number} lens={lens} place={place} />)}
        </Bent>
        <figcaption>
          <span class="side-name">
            {name} <span>with three parts framed</span>
          </span>
        </figcaption>
      </figure>
      {lenses.map((lens) => (
        <Part key={lens.number} lens={lens} {...{ name, maps, bend, box, colouring }} />
      ))}
    </div>
  );
}

function Framed({ lens, place }: { lens: Lens; place: Place }) {
  const half = lens.width / 2;
  const corners: Point[] = [
    [lens.x - half, lens.y - half],
    [lens.x + half, lens.y - half],
    [lens.x + half, lens.y + half],
    [lens.x - half, lens.y + half],
  ];
  const places = corners.map(place);
  const [, , [right = 0, top = 0] = []] = places;
  return (
    <g class={`frame-${lens.kind}`}>
      <path class="part-frame" d={`M${places.map((at) => at.join(" ")).join("L")}Z`} />
      <text class="part-name" x={right + 5} y={top} dy="0.8em">
        {lens.number}
      </text>
    </g>
  );
}

interface PartProps extends Omit<MagnifiedProps, "aspect" | "lenses"> {
  lens: Lens;
}

function Part({ lens, name, maps, bend, box, colouring = "map" }: PartProps) {
  const { x, y, width, number, kind, about } = lens;
  const part = useMemo<Box>(() => {
    const half = width / 2;
    return { x0: x - half, y0: y - half, x1: x + half, y1: y + half };
  }, [x, y, width]);
  const times = fixed((box.x1 - box.x0) / width, 1);
  return (
    <figure class="panel">
      <div class={`part frame-${kind}`}>
        <Bent
          maps={maps}
          bend={bend}
          box={part}
          margin={0}
          grid={0}
          colouring={colouring}
          label={`${name}-${number}: ${about}, ${times} times larger`}
        />
      </div>
      <figcaption>
        <span class="side-name">
          {name}-{number} <span>{about}</span>
        </span>
      </figcaption>
    </figure>
  );
}
