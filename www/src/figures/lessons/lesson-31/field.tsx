/** The gasket with a cell to reach, and the point that is thrown. */
import type { ComponentChildren } from "preact";
import { fitFor } from "#document/framing";
import { dark } from "#document/preferences";
import { orbitOf } from "#geometry/maps/orbit";
import { cellOf, isIn } from "#geometry/maps/target";
import { palette } from "#style/palette";
import { Cell, OrbitPath } from "#ui/orbit/OrbitPath";
import { HEIGHT } from "../../kit/maps/families";
import { apply, type Point } from "../../kit/maps/pieces";
import { Drawn, PieceNames } from "../../kit/picture/annotated";
import { useValue } from "../../kit/workers";
import { BOARD, BOX, MAPS } from "./cells";
import css from "./field.module.css";

interface FieldProps {
  label: string | null;
  /** The cell that is framed. */
  target?: readonly number[];
  /** The throws, the first one first. */
  throws: readonly number[];
  /** Where it begins: in the middle, unless it is said. */
  points?: readonly Point[];
  inverse?: boolean;
  size?: number;
  onPick?: (letter: number) => void;
}

/** How a picture of 4 to 3 is drawn: see `Drawn`. */
const UNITS = { width: 400, height: 300 };
const MARGIN = 0.06;
const MIDDLES = MAPS.map((map) => apply(map, BOARD.start));
/** The names of the pieces stand beside their corners: points are thrown into their middles. */
const NAMED: readonly { corner: Point; by: Point }[] = [
  { corner: [0, 0], by: [-16, -4] },
  { corner: [1, 0], by: [16, -4] },
  { corner: [0.5, HEIGHT], by: [22, 8] },
];

export const useColours = (): readonly string[] => palette(useValue(dark) ? "dark" : "light");

export function Field({ label, target, throws, points, inverse = false, size = 1, onPick }: FieldProps) {
  const colours = useColours();
  const way = points ?? orbitOf(MAPS, BOARD.start, throws);
  const here = way.at(-1) ?? BOARD.start;
  const press = (event: PointerEvent) => {
    const { left, top, width } = (event.currentTarget as Element).getBoundingClientRect();
    const view = fitFor(BOX, UNITS, MARGIN);
    const unit = UNITS.width / width / view.scale;
    const x = view.x + (event.clientX - left - width / 2) * unit;
    const y = view.y - (event.clientY - top - (width * 3) / 8) * unit;
    const far = MIDDLES.map(([u, v]) => Math.hypot(u - x, v - y));
    onPick?.(far.indexOf(Math.min(...far)));
  };
  return (
    <Pressed onPress={onPick && press}>
      <Drawn maps={MAPS} box={BOX} label={label}>
        {(place) => (
          <>
            <PieceNames
              at={NAMED.map(({ corner, by }) => {
                const [x, y] = place(corner);
                return [x + by[0], y + by[1]];
              })}
            />
            {target && (
              <Cell corners={cellOf(BOARD, target)} place={place} reached={isIn(BOARD, target, here)} />
            )}
            <OrbitPath
              points={way}
              letters={throws}
              colours={colours}
              place={place}
              inverse={inverse}
              size={size}
            />
          </>
        )}
      </Drawn>
    </Pressed>
  );
}

/** A press of it does what the buttons beside it do, and the keys. */
function Pressed({
  onPress,
  children,
}: {
  onPress: ((event: PointerEvent) => void) | undefined;
  children: ComponentChildren;
}) {
  if (!onPress) return <>{children}</>;
  return (
    <div class={css["pressed"]} onPointerDown={onPress}>
      {children}
    </div>
  );
}
