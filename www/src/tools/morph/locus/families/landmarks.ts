/** Places of the polygon families that are worth seeing, and who found them. */
import { lowered } from "#format/parameters";
import type { Uv } from "#geometry/path";
import * as messages from "../messages";

export interface Landmark {
  name: string;
  about: string;
  /** Whose it is, in print; or that it is computed here. */
  source: string;
  s: Uv;
  zoom: number;
  /** Around it the map looks like itself, turned and magnified as a multiplication by 1/s does. */
  spiral?: true;
}

const LATTICE = messages.bandtGelbrich1994Apart;
const SERIES = messages.onlyPowerSeriesWith + messages.bandt2002MRepeats;

const OF_M: readonly Landmark[] = [
  {
    name: messages.twinDragon,
    about: messages.twinDragonAbout,
    source: LATTICE,
    s: [0.5, 0.5],
    zoom: 3,
  },
  {
    name: messages.tameDragon,
    about: messages.tameDragonAbout,
    source: LATTICE,
    s: [0.25, Math.sqrt(7) / 4],
    zoom: 3,
  },
  {
    name: messages.rectangle,
    about: messages.rectangleAbout,
    source: messages.everyOtherSignMoves,
    s: [0, Math.SQRT1_2],
    zoom: 3,
  },
  {
    name: messages.realTip,
    about: messages.realTipAbout,
    source: messages.barnsleyHarrington1985,
    s: [0.5, 0],
    zoom: 6,
  },
  {
    name: messages.dendrite,
    about: messages.dendriteAbout,
    source: `1 − s − s² + s³ + s⁴ + s⁵ + …: ${SERIES}`,
    s: [0.5957439419765593, 0.254425889416369],
    zoom: 20,
    spiral: true,
  },
  {
    name: messages.slimDendrite,
    about: messages.slimDendriteAbout,
    source: `1 − s − s² − s³ + s⁴ + s⁵ + …: ${SERIES}`,
    s: [0.6360098247570345, 0.10692431112128839],
    zoom: 60,
    spiral: true,
  },
  {
    name: messages.hole,
    about: messages.holeAbout,
    source: messages.firstSeenByBarnsley,
    s: [0.0227, 0.703],
    zoom: 300,
  },
  {
    name: messages.spiralHoles,
    about: messages.spiralAbout,
    source: messages.calegariKochWalker2017,
    s: [0.37185868007413647, 0.5194111537479428],
    zoom: 1500,
    spiral: true,
  },
];

/** A short list of places to fly to. Where the family closes on the real line, `r`, is one of them. */
export function landmarksOf(sides: number, r: number): readonly Landmark[] {
  if (sides === 2) return OF_M;
  return [
    {
      name: `r${lowered(sides)}`,
      about: messages.realClosing(sides),
      source: messages.knownAndComputedHere,
      s: [r, 0],
      zoom: 6,
    },
  ];
}

/** The landmark that lies at s, but for rounding. */
export const landmarkAt = (all: readonly Landmark[], [x, y]: Uv): Landmark | undefined =>
  all.find(({ s }) => Math.hypot(s[0] - x, s[1] - y) < 1e-9);
