import { useMemo } from "preact/hooks";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import type { Bend, Colouring, MapRow } from "#wasm/api";
import { bends } from "#wasm/bend";
import { Panel } from "../../kit/frame/panel";
import type { Point } from "../../kit/maps/pieces";
import type { Place } from "../../kit/picture/annotated";
import { Bent } from "../../kit/picture/deformed";
import css from "./magnified.module.css";

/** A part that is shown larger. */
export interface Lens {
  number: number;
  kind: "red" | "blue" | "green" | "black";
  about: string;
  /** The point that stays in its middle, by its code: the frame goes where the bend takes it. */
  code: number[];
  /** How wide and how high it is, in units of the plane. */
  width: number;
}

interface MagnifiedProps {
  /** The panel that is magnified. */
  name: string;
  maps: MapRow[];
  bend: Bend;
  /** What part of the plane the panel shows. */
  box: Box;
  aspect: number;
  colouring?: Colouring;
  lenses: readonly Lens[];
}

/** Where the middles of the lenses are. */
function useMiddles({ maps, bend, lenses }: Pick<MagnifiedProps, "maps" | "bend" | "lenses">): Point[] {
  return useMemo(() => {
    const codes = lenses.map(({ code }) => code);
    const places = bends().deform(
      { maps },
      bend,
      codes,
      codes.map(() => [0, 0]),
    );
    return lenses.map((_, i): Point => [places[2 * i] ?? 0, places[2 * i + 1] ?? 0]);
  }, [maps, bend, lenses]);
}

/** A bent shape with a frame on it for each lens. */
export function WithFrames({ name, aspect, lenses, ...picture }: MagnifiedProps) {
  const middles = useMiddles({ ...picture, lenses });
  return (
    <Panel name={name} words={`with ${lenses.length} parts framed`}>
      <Bent
        {...picture}
        aspect={aspect}
        grid={0}
        label={`${name} again, with frames round ${lenses.length} parts`}
      >
        {(place) =>
          lenses.map((lens, i) => (
            <Framed key={lens.number} lens={lens} middle={middles[i] ?? [0, 0]} place={place} />
          ))
        }
      </Bent>
    </Panel>
  );
}

/** What is in the frames. */
export function Magnified({ lenses, ...rest }: Omit<MagnifiedProps, "aspect">) {
  const middles = useMiddles({ ...rest, lenses });
  return (
    <div class={css["magnified"]}>
      {lenses.map((lens, i) => (
        <Part key={lens.number} lens={lens} middle={middles[i] ?? [0, 0]} {...rest} />
      ))}
    </div>
  );
}

function Framed({ lens, middle: [x, y], place }: { lens: Lens; middle: Point; place: Place }) {
  const half = lens.width / 2;
  const corners: Point[] = [
    [x - half, y - half],
    [x + half, y - half],
    [x + half, y + half],
    [x - half, y + half],
  ];
  const places = corners.map(place);
  const [, , [right = 0, top = 0] = []] = places;
  return (
    <g class={css[`frame-${lens.kind}`]}>
      <path class={css["part-frame"]} d={`M${places.map((at) => at.join(" ")).join("L")}Z`} />
      <text class={css["part-name"]} x={right + 5} y={top} dy="0.8em">
        {lens.number}
      </text>
    </g>
  );
}

interface PartProps extends Omit<MagnifiedProps, "aspect" | "lenses"> {
  lens: Lens;
  middle: Point;
}

function Part({ lens, middle: [x, y], name, maps, bend, box, colouring = "map" }: PartProps) {
  const { width, number, kind, about } = lens;
  const part = useMemo<Box>(() => {
    const half = width / 2;
    return { x0: x - half, y0: y - half, x1: x + half, y1: y + half };
  }, [x, y, width]);
  const times = fixed((box.x1 - box.x0) / width, 1);
  return (
    <Panel name={`${name}-${number}`} words={about}>
      <div class={`${css["part"]} ${css[`frame-${kind}`]}`}>
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
    </Panel>
  );
}
