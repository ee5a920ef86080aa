import type { Uv } from "#geometry/path";
import type { Deformation, DirectedShape, Fit, MapRow, Mode, Scene, Shape } from "#wasm/api";
import { frond } from "#wasm/core";

interface Opening {
  a: Shape;
  b: Shape;
  t?: number;
  mode?: Mode;
  compare?: boolean;
  path?: Scene["path"];
  /** For each map of A the map of B that it becomes; the same number by default. */
  correspondence?: number[];
  /** Whole turns that each map makes more; none by default. */
  turns?: number[];
  /** How the map of shapes is looked at. */
  locus?: NonNullable<Scene["locus"]>;
  /** Opens the tool that bends shapes. */
  deform?: Deformation;
  /** Opens another tool than the morph. */
  tool?: Scene["tool"];
}

/** A link that opens the studio on a figure: the document is in its fragment. */
export function studioHref({
  a,
  b,
  t = 0,
  mode = "polar",
  compare = false,
  path,
  correspondence = [],
  turns = [],
  locus,
  deform,
  tool,
}: Opening): string {
  const scene: Scene = {
    a: tidy(a),
    b: tidy(b),
    mode,
    path: path ?? { kind: "straight", points: [] },
    t: Math.min(1, Math.max(0, t)),
    correspondence,
    turns,
    colouring: deform?.tint ? "grid" : "map",
    compare,
    ...(locus ? { locus } : {}),
    ...(tool ? { tool } : {}),
    ...(deform ? { tool: "deform", deform } : {}),
  };
  return `#${frond.encodeScene(scene)}`;
}

/** Without the dust of binary fractions: 0.45, not 0.44999999999999996. Shapes of the gallery stay as they are. */
export function tidy(shape: Shape): Shape {
  if (shape.preset !== undefined) return shape;
  return { ...shape, maps: shape.maps.map((map) => map.map((x) => Number(x.toPrecision(12))) as MapRow) };
}

/** A waypoint that is short in a link, and still far nearer to its place than a locus resolves. */
export function drawn(points: readonly Uv[]): Scene["path"] {
  const short = (x: number) => Math.round(x * 1e6) / 1e6;
  return { kind: "drawn", points: points.slice(1, -1).map(([u, v]): Uv => [short(u), short(v)]) };
}

/** A shape of the gallery. */
export function preset(id: string): Shape & { maps: MapRow[] } {
  const found = frond.presets().find((one) => one.id === id);
  if (!found) throw new Error(`The gallery has no shape "${id}".`);
  return { preset: id, name: found.name, maps: found.maps };
}

/** A link that opens the morph of two graph-directed shapes. Throws where no link can hold them. */
export function directedHref(opening: { a: DirectedShape; b: DirectedShape; mode: Mode; t: number }): string {
  const { a, b, mode, t } = opening;
  return `#${frond.encodeScene({ ...frond.defaultScene(), mode, t, directed: { a, b } })}`;
}

/** A link that opens the tool that fits, with a graph or a curve that is fitted already. */
export function fitHref(fit: Pick<Fit, "mode"> & Partial<Fit>): string {
  const whole: Fit = { model: "closed", numbers: 260, smoothing: 0, ...fit };
  return `#${frond.encodeScene({ ...frond.defaultScene(), tool: "fit", fit: whole })}`;
}
