import wasmUrl from "../../pkg/frond-space_bg.wasm?url";
import type {
  Bounds,
  BoxCount3,
  Connectedness3,
  EpsilonProjection,
  Intersection3,
  MapRow,
  MapRow3,
  MeetExample,
  MorphOptions,
  PathCheck,
  PathPlan,
  PathPoint,
  Place3,
  Point3,
  Preset3,
  Shadow,
  ShapeFacts3,
  Space,
  SpaceFrame,
  SpaceLight,
  SpaceObject,
  SpaceView,
} from "./api";
import { compiled, once } from "./module";

/** What a renderer is given for one object, as its shaders read it. */
export interface CloudBytes {
  vertices: Uint8Array;
  instances: Uint8Array;
  /** About how far points are from each other, in units of the scene. */
  gap: number;
}

/** What a renderer is given for one picture, as its shaders read it. */
export interface UniformBytes {
  eye: Uint8Array;
  /** For the points, one for each pixel shown. */
  lamp: Uint8Array;
  /** For the carved picture, `factor` x `factor` pixels for each one shown. */
  stillLamp: Uint8Array;
  look: Uint8Array;
}

/** How a picture of space looks besides what the document says: what the page decides. */
export interface SpaceLook {
  width: number;
  height: number;
  /** Pixels that are carved for each one shown, each way: 1 or 2. */
  factor: 1 | 2;
  /** "#rrggbb": one a map, repeated. */
  palette: string[];
  /** "#rrggbb": what fog fades into. */
  ground: string;
}

/** The objects of one moment, ready to be drawn. `free()` it. */
export interface SpacePictureHandle {
  /** A ball around everything. */
  readonly centre: Float64Array;
  readonly radius: number;
  /** About so many points in all, shared by the objects. The same for the same objects. */
  clouds(points: number): CloudBytes[];
  /** Throws where there is no such view. */
  uniforms(view: SpaceView, light: SpaceLight, look: SpaceLook): UniformBytes;
  /** The complete picture in the making. */
  carve(view: SpaceView, width: number, height: number): SpaceCarveHandle;
  free(): void;
}

/** A complete picture in the making: for each pixel how far the nearest piece is, and which. `free()` it. */
export interface SpaceCarveHandle {
  /** Looks at so many pieces at most. Whether it is done. */
  run(budget: number): boolean;
  /** Depth, and 1 + the code of the piece, row 0 on top; 0 where there is nothing. */
  depth(): Float32Array<ArrayBuffer>;
  codes(): Uint32Array<ArrayBuffer>;
  /** RGBA, straight alpha, row 0 on top; `look.width` x `look.height` pixels, of which `factor` x `factor` were carved for each. */
  paint(light: SpaceLight, look: SpaceLook): Uint8ClampedArray<ArrayBuffer>;
  free(): void;
}

/** A `Space` at any moment. `free()` it. Its constructor throws where a key cannot be played, with the key in its message. */
export interface SpaceMotionHandle {
  /** Throws where a moment has no attractor. */
  at(seconds: number): SpaceFrame;
  free(): void;
}

/** A locus of a morph in space, row by row. */
export interface SpaceLocusHandle {
  /** Rows from r0 to before r1, every `stride`th sample both ways. */
  run(r0: number, r1: number, stride: number): { state: Uint8Array; gap: Float32Array };
  free(): void;
}

/** Space, in a module of its own: the page has it where the tool is open, and so have its workers. Functions throw `FrondError`. */
export interface SpaceModule {
  presets3(): Preset3[];
  /** The objects of the natural scene; their `preset` ids are `natural-0` and on. */
  naturalScene(): SpaceObject[];
  /** What the tool begins with. */
  defaultSpace(): Space;
  /** The view that shows all of it, from a little above; for the natural scene that of the eye at the origin. */
  defaultView(space: Space): SpaceView;
  /** What a link holds; throws where a number is not finite. */
  packSpace(space: Space): string;
  /** Throws where it is damaged, with a message that says what. */
  unpackSpace(packed: string): Space;
  /** Throws unless they have an attractor. */
  validate3(maps: MapRow3[]): void;
  /** The maps of the moved shape (eq 1). Throws where `by` is singular or nearly so. */
  conjugate3(maps: MapRow3[], by: MapRow3): MapRow3[];
  /** First `inner`, then `outer`. */
  compose3(outer: MapRow3, inner: MapRow3): MapRow3;
  /** Throws where it is singular. */
  invert3(map: MapRow3): MapRow3;
  /** A turn by radians about an axis through a point. */
  turning3(axis: Point3, angle: number, through: Point3): MapRow3;
  place3(transform: MapRow3): Place3;
  facts3(maps: MapRow3[]): ShapeFacts3;
  /** Counted, from a million points. */
  boxes3(maps: MapRow3[]): BoxCount3;
  /** Points by the chaos game: x0, y0, z0, x1, .., and the last map of each. */
  attractor3(
    maps: MapRow3[],
    options: { points: number; seed: number },
  ): { positions: Float32Array; pieces: Uint8Array };
  /** Systems of space in a Fractint file. Throws with the line. */
  parseIfs3(text: string): { name: string; maps: MapRow3[]; probabilities: number[] }[];
  /** How many systems of the plane the same file has: they are passed over. */
  countFlat(text: string): number;
  writeIfs3(name: string, maps: MapRow3[]): string;
  /** Maps of the plane as maps of space, flat at z = 0. */
  lift(maps: MapRow[]): MapRow3[];
  /** Directions that every map keeps: unit vectors; empty where there are none. */
  invariantDirections(maps: MapRow3[]): Point3[];
  /** The system of the plane whose attractor is the shadow, where the direction is kept; throws `project-not-kept` else. */
  projectExactly(maps: MapRow3[], direction: Point3): MapRow[];
  shadow(maps: MapRow3[], direction: Point3, options: { points: number; seed: number }): Shadow;
  epsilonProjection(maps: MapRow3[], direction: Point3, epsilon: number): EpsilonProjection;
  correspondence3(from: MapRow3[], to: MapRow3[]): number[];
  /** Morph at (u, v, w). There need not be an attractor. */
  interpolate3(
    from: MapRow3[],
    to: MapRow3[],
    options: MorphOptions & { u: number; v: number; w?: number },
  ): MapRow3[];
  connectedness3(maps: MapRow3[], options?: { epsilon?: number; budget?: number }): Connectedness3;
  SpaceLocus: new (
    from: MapRow3[],
    to: MapRow3[],
    options: MorphOptions & { bounds?: Bounds; width: number; height: number; epsilon?: number },
  ) => SpaceLocusHandle;
  findPath3(
    from: MapRow3[],
    to: MapRow3[],
    options?: MorphOptions & { epsilon?: number; size?: number },
  ): PathPlan;
  checkPath3(
    from: MapRow3[],
    to: MapRow3[],
    points: readonly PathPoint[],
    options?: MorphOptions & { epsilon?: number; samples?: number },
  ): PathCheck;
  intersection3(first: MapRow3[], second: MapRow3[], options?: { points?: number }): Intersection3;
  meetExamples(): MeetExample[];
  SpacePicture: new (objects: { maps: MapRow3[]; tint?: string }[]) => SpacePictureHandle;
  SpaceMotion: new (space: Space) => SpaceMotionHandle;
}

/** Fetches and compiles; the page and its workers are given the module. */
export const compileSpace = once(() => compiled(wasmUrl));

/** What computes space on this thread. Usable once `loadSpace` has resolved. */
export const solid = {} as SpaceModule;

/** Starts it on this thread. */
export const loadSpace = once(async (): Promise<void> => {
  await startSpace(await compileSpace());
});

export async function startSpace(module: WebAssembly.Module): Promise<void> {
  const bindings = await import("../../pkg/frond-space.js");
  await bindings.default({ module_or_path: module });
  Object.assign(solid, bindings);
}
