/** What is asked about two shapes of a grid, and what comes back. */
import { useMemo } from "preact/hooks";
import { fitFor } from "#document/framing";
import { type Box, union } from "#geometry/boxes";
import type { Size } from "#geometry/coordinates";
import { WHITE } from "#style/colours";
import type { DigitSystem, GridIntersection } from "#wasm/api";
import { directed } from "#wasm/directed";
import { useDirected } from "../../kit/directed/ask";
import { look } from "../../kit/directed/look";
import type { Grid } from "./grids";
import { bitmapSize, type Layers } from "./overlay";
import type { Shift } from "./shift";

/** Where a shape lies. */
export function boxOf(system: DigitSystem): Box {
  const seen = look(directed.digitShape(system, {}));
  return (typeof seen === "string" ? undefined : seen.boxes[0]) ?? { x0: 0, y0: 0, x1: 1, y1: 1 };
}

interface Question {
  grid: Grid;
  first: DigitSystem;
  second: DigitSystem;
  shift: Shift;
  /** Where the two lie while the second is not moved. */
  boxes: readonly [Box, Box];
  /** The canvas; null while there is none. */
  size: Size | null;
}

interface Meeting {
  layers: Layers;
  found: GridIntersection | null;
  problem: string | null;
  /** Whether it is still about the question before. */
  stale: boolean;
  /** Pixels of the canvas for a unit of the plane. */
  scale: number;
}

/** Room around both, in which the second can be moved before more of the plane is shown. */
const ROOM = 0.12;
const MARGIN = 0.03;
/** What is of less than this dimension is drawn thicker. */
const THIN = 1.2;

/** What is to be seen: both where they lie at first with room around, and the second where it lies now. */
function viewed([first, second]: readonly [Box, Box], [dx, dy]: readonly [number, number]): Box {
  const both = union([first, second]);
  const room = ROOM * Math.max(both.x1 - both.x0, both.y1 - both.y0);
  const around = { x0: both.x0 - room, y0: both.y0 - room, x1: both.x1 + room, y1: both.y1 + room };
  const moved = { x0: second.x0 + dx, y0: second.y0 + dy, x1: second.x1 + dx, y1: second.y1 + dy };
  return union([around, moved]);
}

/** The two shapes and what they share, drawn aside. What was found last stays until there is something new. */
export function useMeeting({ grid, first, second, shift, boxes, size }: Question): Meeting {
  const { isLine } = grid;
  const [x, y, over] = shift;
  const box = viewed(boxes, [x / over, y / over]);
  const { x0, y0, x1, y1 } = box;
  const view = useMemo(
    () => fitFor({ x0, y0, x1, y1 }, size ?? { width: 1, height: 1 }, MARGIN),
    [x0, y0, x1, y1, size],
  );
  const options = useMemo(
    () => (size ? { ...bitmapSize(size, isLine), view, palette: [WHITE], smooth: !isLine } : null),
    [size, isLine, view],
  );
  const own = useMemo(
    () => (options ? { system: directed.digitShape(first, {}), options } : null),
    [first, options],
  );
  const both = useMemo(
    () =>
      options
        ? {
            first,
            second,
            shift: { numerators: [x, y] as [number, number], denominator: over },
            options,
          }
        : null,
    [first, second, x, y, over, options],
  );
  const alone = useDirected("picture", own, 1);
  const met = useDirected("meeting", both, 0);
  const result = met?.result ?? null;
  const found = result?.found ?? null;
  const layers = useMemo((): Layers => {
    const points = found?.points ?? [];
    const { width, height } = size ?? { width: 1, height: 1 };
    return {
      first: alone?.result ?? null,
      second: result?.second ?? null,
      shared: result?.shared ?? null,
      thin: (found?.dimension ?? 2) < THIN,
      marks: points
        .slice(0, MOST_MARKS)
        .map(([px, py]) => [
          0.5 + ((px - view.x) * view.scale) / width,
          isLine ? 0.5 : 0.5 - ((py - view.y) * view.scale) / height,
        ]),
    };
  }, [alone, result, found, size, view, isLine]);
  return {
    layers,
    found,
    problem: met?.problem ?? result?.problem ?? null,
    stale: met?.about !== both,
    scale: view.scale,
  };
}

/** Points that are ringed. */
const MOST_MARKS = 64;
