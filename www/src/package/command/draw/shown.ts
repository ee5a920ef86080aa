/** What a link shows: a morph, a bend, or space, ready to be drawn at any moments. */
import { type Box, boxAt, calmTrack, stillTrack, union } from "#geometry/boxes";
import { WHITE } from "#style/colours";
import { palette } from "#style/palette";
import type { Bend, DirectedIfs, Ifs, Scene } from "#wasm/api";
import { shownObject } from "#workers/space/shown";
import type { Draw, Pixels } from "../modules";
import { bendOf, morphOf, type NamedMaps, withColours } from "../morph";
import { Refusal } from "../options";
import type { Subject } from "../subject";
import type { System } from "../system";
import type { Drawing } from "./frame";

export interface Look {
  width: number;
  height: number;
  /** "#rrggbb", or null where it is clear. */
  ground: string | null;
}

export interface Shown {
  /** How long it takes once through. */
  seconds: number;
  /** The moment that the link says, 0 to 1 as all moments. */
  t: number;
  /** Its end goes on to its beginning. */
  round: boolean;
  /** Why there is nothing to film. */
  still: string | null;
  /** The maps of a moment, where these are all that there is to see. */
  plain?: (t: number) => Promise<NamedMaps>;
  /** The document, at this moment. */
  at(moment: number): Scene;
  /** Makes ready what is needed for these moments; then each can be drawn. */
  frames(moments: number[], look: Look): Promise<(i: number) => Drawing>;
}

/** How often the way is looked at for where the camera goes. */
const LOOKS = 13;
/** Free on each side, as a part of the shorter one. */
const MARGIN = 0.06;
const MORPH_SECONDS = 8;
/** Pixels a side of the small pictures that tell where a bent shape is, and how many are drawn, each nearer. */
const TRIAL = 128;
const TRIALS = 2;

export function shownOf({ scene, maps }: Subject, system: System): Promise<Shown> {
  if (scene.tool === "space") return spaceShown(scene, system);
  const { directed } = scene;
  return directed ? directedShown(scene, directed, system) : planeShown(scene, maps, system);
}

/** Shapes of several states: the straight way from one to the other. */
async function directedShown(
  scene: Scene,
  { a, b }: NonNullable<Scene["directed"]>,
  system: System,
): Promise<Shown> {
  const { mode, t, colouring, palette: own, tool } = scene;
  if (tool === "deform" || tool === "fit")
    throw new Refusal("Shapes of several states are shown by Morph. Open the link there and copy it again.");
  const { directedFacts, interpolateDirected } = await system.directed();
  const at = (moment: number): DirectedIfs => {
    if (moment <= 0) return a;
    return moment >= 1 ? b : interpolateDirected(a, b, { u: moment, v: moment, mode });
  };
  return {
    seconds: MORPH_SECONDS,
    t,
    round: false,
    still: null,
    at: (moment) => ({ ...scene, t: moment }),
    async frames(moments, { width, height, ground }) {
      const looks = moments.length === 1 ? moments : Array.from({ length: LOOKS }, (_, i) => i / (LOOKS - 1));
      const boxes = looks.map((moment): Box | null => {
        try {
          const [whole] = directedFacts(at(moment)).states;
          return whole ? { x0: whole.min[0], y0: whole.min[1], x1: whole.max[0], y1: whole.max[1] } : null;
        } catch {
          return null;
        }
      });
      const track = calmTrack(boxes);
      const colours = own ?? palette(ground !== null && dark(ground) ? "dark" : "light");
      const look =
        colouring === "address"
          ? { level: STATE_LEVEL, palette: colours }
          : { level: 0, palette: colouring === "map" ? colours : colours.slice(0, 1) };
      return (i) => {
        const moment = moments[i] ?? 0;
        const view = viewOf(boxAt(track, moment), width, height);
        return { kind: "states", ifs: at(moment), options: { width, height, view, ...look } };
      };
    },
  };
}

/** Maps that lead to the state that a colour tells. */
const STATE_LEVEL = 3;

async function planeShown(scene: Scene, alone: NamedMaps | undefined, system: System): Promise<Shown> {
  const { draw, at } = await morphOf(scene, system);
  const bend = bendOf(scene);
  const { deform, tool, t } = scene;
  /** Time bends, and does not morph. */
  const bending = tool === "deform";
  const mapsAt = async (moments: number[]) =>
    // What a file holds is not taken apart and put together again.
    alone ? moments.map(() => alone) : at(bending ? moments.map(() => t) : moments);
  const bendNow = (moment: number) => bend?.(bending ? moment : (deform?.phase ?? 0)) ?? null;
  const name = bending ? (t < 0.5 ? scene.a.name : scene.b.name) : `${scene.a.name} to ${scene.b.name}`;
  const plain = async (moment: number) =>
    alone ?? withColours((await mapsAt([moment]))[0] ?? { maps: [] }, name, scene);
  const oneKey =
    bending && (deform?.keys.length ?? 0) < 2 ? "it has one key frame, and so stands still" : null;
  return {
    seconds: bending && deform ? deform.seconds : MORPH_SECONDS,
    t: bending && deform ? deform.phase : t,
    round: bending && deform?.loop === true,
    still: alone ? "a file of maps is one shape, and stands still" : oneKey,
    ...(bend ? {} : { plain }),
    at: (moment) =>
      bending && deform ? { ...scene, deform: { ...deform, phase: moment } } : { ...scene, t: moment },
    async frames(moments, { width, height, ground }) {
      const looks = moments.length === 1 ? moments : Array.from({ length: LOOKS }, (_, i) => i / (LOOKS - 1));
      const seen = await mapsAt(looks);
      const boxes = await Promise.all(seen.map((ifs, i) => boxOf(draw, system, ifs, bendNow(looks[i] ?? 0))));
      const there = boxes.filter((box) => box !== null);
      const track = bending && there.length > 0 ? stillTrack(union(there), 2) : calmTrack(boxes);
      const systems = await mapsAt(moments);
      const lightGround = ground === null || !dark(ground);
      const colours = scene.palette ?? palette(lightGround ? "light" : "dark");
      return (i) => {
        const moment = moments[i] ?? 0;
        const view = viewOf(boxAt(track, moment), width, height);
        const now = bendNow(moment);
        const style = {
          colouring: scene.colouring,
          palette: colours,
          lightGround,
          ...(now ? { bend: now } : {}),
        };
        return { kind: "plane", ifs: systems[i] ?? { maps: [] }, options: { width, height, view, ...style } };
      };
    },
  };
}

async function spaceShown(scene: Scene, system: System): Promise<Shown> {
  const { space: part } = scene;
  const { SpaceMotion, defaultSpace, defaultView, unpackSpace } = await system.space();
  const space = part?.packed ? unpackSpace(part.packed) : defaultSpace();
  const line = space.timeline && space.timeline.keys.length > 0 ? space.timeline : null;
  const seconds = line?.seconds ?? 1;
  return {
    seconds,
    t: Math.min(1, (part?.at ?? 0) / seconds),
    round: line?.loop === "round",
    still: line ? null : "it has no key frames, and so stands still",
    at: (moment) => ({ ...scene, space: { packed: "", ...part, at: moment * seconds } }),
    async frames(moments, { width, height, ground }) {
      const motion = new SpaceMotion(space);
      const frames = moments.map((moment) => motion.at(moment * seconds));
      motion.free();
      const colours = palette(ground !== null && dark(ground) ? "dark" : "light");
      // Four looks for each pixel, where there is room for so many.
      const factor = width * height <= MOST_SMOOTH ? 2 : 1;
      const look = { width, height, factor, palette: colours, ground: ground ?? WHITE };
      return (i) => {
        const frame = frames[i];
        if (!frame) throw new Refusal("There is no such frame.");
        const objects = frame.objects.map((at, k) => shownObject(at, space.objects[k]));
        const flown = part?.own ? undefined : frame.view;
        const view = flown ?? part?.view ?? defaultView(space);
        return { kind: "space", picture: { objects, view, light: space.light, look } };
      };
    },
  };
}

/** Above so many pixels pictures of space are not smoothed: each takes some forty bytes a look. */
const MOST_SMOOTH = 4_000_000;

/** Where a shape is; of a bent one, by small pictures. Null where it is none. */
async function boxOf(draw: Draw, system: System, ifs: Ifs, bend: Bend | null): Promise<Box | null> {
  let box: Box;
  try {
    const { min, max } = draw.bounds(ifs);
    box = { x0: min[0], y0: min[1], x1: max[0], y1: max[1] };
  } catch {
    return null;
  }
  if (!bend) return box;
  const { reach } = draw.bendFacts(ifs, bend);
  box = { x0: box.x0 - reach, y0: box.y0 - reach, x1: box.x1 + reach, y1: box.y1 + reach };
  for (let trial = 0; trial < TRIALS; trial++) {
    const view = viewOf(box, TRIAL, TRIAL);
    const drawing: Drawing = { kind: "plane", ifs, options: { width: TRIAL, height: TRIAL, view, bend } };
    const pixels = await system.pool().pixels({ drawing, width: TRIAL, height: TRIAL, ground: null });
    box = litBox(pixels, view) ?? box;
  }
  return box;
}

function litBox(pixels: Pixels, { x, y, scale }: ReturnType<typeof viewOf>): Box | null {
  let [left, right, top, bottom] = [TRIAL, -1, TRIAL, -1];
  for (let i = 0; i < TRIAL * TRIAL; i++) {
    if (!pixels[4 * i + 3]) continue;
    const [column, row] = [i % TRIAL, Math.floor(i / TRIAL)];
    [left, right] = [Math.min(left, column), Math.max(right, column)];
    [top, bottom] = [Math.min(top, row), Math.max(bottom, row)];
  }
  if (right < 0) return null;
  const [across, up] = [
    (column: number) => x + (column - TRIAL / 2) / scale,
    (row: number) => y - (row - TRIAL / 2) / scale,
  ];
  return { x0: across(left), y0: up(bottom + 1), x1: across(right + 1), y1: up(top) };
}

function dark(ground: string): boolean {
  const value = Number.parseInt(ground.slice(1), 16);
  return (value >> 16) + ((value >> 8) & 255) + (value & 255) < 384;
}

function viewOf({ x0, y0, x1, y1 }: Box, width: number, height: number) {
  const edge = 2 * MARGIN * Math.min(width, height);
  const across = (width - edge) / (x1 - x0);
  const up = (height - edge) / (y1 - y0);
  const scale = Math.min(...[across, up].filter((value) => Number.isFinite(value) && value > 0), 1e9);
  return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, scale };
}
