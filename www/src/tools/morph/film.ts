/** What there is to film of a morph: its way from the first shape to the last, and a shape in the making. */

import { along, locus, standInFilm } from "#compute/results";
import { curveDrawer } from "#curve/film";
import { directedDrawer } from "#directed/film";
import { pieceColours } from "#document/colours";
import { curved, curveMorph } from "#document/curve/curve";
import { photographs, photographsShown } from "#document/curve/photographs";
import { bend } from "#document/deform/bend";
import { directedShapes, directedWay } from "#document/directed/directed";
import { pathTrack } from "#document/framing";
import { mapsBetween, morphOptions, pairing, pathPoints, shown, uvAt } from "#document/morph";
import { loop, speed } from "#document/playback";
import { dark } from "#document/preferences";
import { scene } from "#document/scene";
import { standIn } from "#document/stand-in";
import { sharesNow, weightsBetween } from "#document/weights";
import { stepsSubject } from "#film/steps";
import type { FilmSubject, Films } from "#film/subject";
import { percent } from "#format/path-words";
import { verdictPhrase } from "#format/verdict";
import { boxAt } from "#geometry/boxes";
import { SECONDS } from "#geometry/moment";
import type { Uv } from "#geometry/path";
import { frameView } from "#stage/frame-view";
import { paint } from "#stage/locus/paint";
import { nearColours } from "#stage/near-colours";
import { NIGHT, PAPER } from "#style/colours";
import { isDark } from "#style/ground";
import { plainName } from "#ui/files/download";
import type { Pairing } from "#wasm/api";
import { planeDrawer } from "#workers/film/plane-drawer";
import type { Drawer, FrameLook, Inset, Place } from "#workers/film/subject";
import * as messages from "./messages";

/** What stands there now is taken once: the document may change while the film is made. */
export async function films(): Promise<Films> {
  const { a, b, colouring } = scene.peek();
  const pair = pairing.peek();
  const shares = sharesNow();
  const palettes = { light: pieceColours("light"), dark: pieceColours("dark") };
  const track = pathTrack.peek();
  const bent = bend.peek();
  const seconds = SECONDS / speed.peek();
  const ground = dark.peek() ? NIGHT : PAPER;
  const curve = curved.peek() ? curveMorph.peek() : null;
  const way = directedWay.peek();
  const frames = standInFilm.peek();
  const instead = standIn.peek();
  const leaves = curve ? photographs.peek() : null;
  const leavesShown = photographsShown.peek();
  const points = pathPoints.peek();
  const options = morphOptions.peek();
  const told = along.peek()?.told;
  const moment = (at: number) => Math.min(1, Math.max(0, at / seconds));

  const drawer = (look: FrameLook, how?: { alone: boolean }): Drawer => {
    const view = (t: number) => frameView(boxAt(track, t), look);
    if (curve) {
      const curveAt = (at: number) => ({ s: moment(at), bend: bent, view: view(moment(at)) });
      return curveDrawer(look, colouring, curveAt, (look.photograph ?? leavesShown) ? leaves : null);
    }
    if (way) {
      return directedDrawer(look, way, colouring, (at) => ({ t: moment(at), view: view(moment(at)) }));
    }
    const lightGround = !isDark(look.ground);
    const palette = palettes[lightGround ? "light" : "dark"];
    return planeDrawer(look, how?.alone ?? false, (at) => {
      const t = moment(at);
      const here = uvAt(points, t);
      const maps = mapsBetween(pair, here, options);
      const seen = view(t);
      // A bend keeps near what is near.
      const colours = nearColours(maps, palette, boxAt(track, t), seen.scale);
      return {
        maps,
        weights: weightsBetween(pair, shares, here, options),
        options: { view: seen, colouring, palette: colours, lightGround, ...(bent ? { bend: bent } : {}) },
      };
    });
  };

  const ends = way ? directedShapes.peek() : null;
  const name = [ends?.a ?? a, ends?.b ?? b].map((end) => plainName(end.name, "shape", 24)).join("-");
  const morph: FilmSubject = {
    id: "morph",
    label: messages.morph,
    name,
    seconds,
    anyLength: true,
    loops: ["once", "pingpong"],
    loop: loop.peek() ? "pingpong" : "once",
    easing: "ease",
    ground,
    choosesSmooth: false,
    ...(leaves ? { photograph: leavesShown } : {}),
    caption: (at) => {
      const t = moment(at);
      const known = way
        ? frames[Math.round(t * (frames.length - 1))]?.verdict
        : told?.[Math.round(t * (told.length - 1))];
      const words = curve ? messages.oneClosedCurve : known ? verdictPhrase(known) : null;
      return words === null ? percent(t) : `${percent(t)}, ${words}`;
    },
    ...(instead ? {} : insetOf(pair, points, moment)),
    drawer,
  };
  const steps = instead ? null : stepsSubject(shown.peek(), plainName(nearer(), "shape", 24), ground);
  return { subjects: steps ? [morph, steps] : [morph] };
}

/** Pixels along a side of the small map. */
const INSET = 512;

/** The map of parameters with the path. Where a path leaves the plane that it shows there is none. */
function insetOf(pair: Pairing, points: readonly Uv[], moment: (at: number) => number): { inset?: Inset } {
  if (points.some(([, , w = 0]) => w !== 0)) return {};
  const field = locus.peek();
  if (!field) return {};
  const { u0, u1, v0, v1 } = field.bounds;
  const place = ([u, v]: Uv): Place => [(u - u0) / (u1 - u0), (v1 - v) / (v1 - v0)];
  return {
    inset: {
      map: () => ({
        size: INSET,
        // More of the map may be known by now, but not if it is that of other shapes.
        pixels: paint((pairing.peek() === pair && locus.peek()) || field, INSET, { style: "gap" }),
        way: points.map(place),
      }),
      at: (at) => place(uvAt(points, moment(at))),
    },
  };
}

/** The name of the end that is on the stage, or on the way. */
function nearer(): string {
  const { a, b, t } = scene.peek();
  if (t === 0) return a.name;
  return t === 1 ? b.name : messages.fromTo(a.name, b.name);
}
