/** Places of the polygon families that are worth seeing, and who found them. */
import { lowered } from "#format/parameters";
import type { Uv } from "#geometry/path";

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

const LATTICE =
  "Bandt & Gelbrich (1994): besides a rectangle the two twin dragons are all that two copies tile so";
const SERIES =
  "the only series of 1, 0 and −1 that is 0 there, computed here, so that the two pieces share one point. On such series " +
  "Bandt (2002); that the map looks like itself at such points, Solomyak (2005)";

const OF_M: readonly Landmark[] = [
  {
    name: "Twin dragon",
    about: "s = 1/2 + i/2: the twin dragon, which tiles the plane",
    source: LATTICE,
    s: [0.5, 0.5],
    zoom: 3,
  },
  {
    name: "Tame dragon",
    about: "s = 1/4 + i √7/4: the tame twin dragon, the other one that tiles",
    source: LATTICE,
    s: [0.25, Math.sqrt(7) / 4],
    zoom: 3,
  },
  {
    name: "Rectangle",
    about: "s = i/√2: a rectangle, √2 times as long as wide, as a sheet of A4 is",
    source: "Every second sign moves along one side: two intervals, written in base −2",
    s: [0, Math.SQRT1_2],
    zoom: 3,
  },
  {
    name: "Real tip",
    about: "s = 1/2: a line, and the last real s that holds together",
    source: "Barnsley & Harrington (1985)",
    s: [0.5, 0],
    zoom: 6,
  },
  {
    name: "Dendrite",
    about: "s ≈ 0.5957 + 0.2544 i, where 1 − 2s + 2s³ = 0: a tree, whose two pieces meet in one point",
    source: `1 − s − s² + s³ + s⁴ + s⁵ + …: ${SERIES}`,
    s: [0.5957439419765593, 0.254425889416369],
    zoom: 20,
    spiral: true,
  },
  {
    name: "Slim dendrite",
    about: "s ≈ 0.6360 + 0.1069 i, where 1 − 2s + 2s⁴ = 0: a tree nearer to the real tip",
    source: `1 − s − s² − s³ + s⁴ + s⁵ + …: ${SERIES}`,
    s: [0.6360098247570345, 0.10692431112128839],
    zoom: 60,
    spiral: true,
  },
  {
    name: "A hole",
    about: "s = 0.0227 + 0.703 i: broken, deep in what holds together",
    source: "Barnsley & Harrington (1985) saw it; that there are holes Bandt (2002) proved",
    s: [0.0227, 0.703],
    zoom: 300,
  },
  {
    name: "Spiral of holes",
    about:
      "s ≈ 0.371859 + 0.519411 i, where 1 − 2s + 2s² − 2s⁵ + 2s⁸ = 0: holes, ever smaller, wind about this point",
    source: "Calegari, Koch & Walker (2017), Theorem 9.1.1",
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
      about: `The real s at which the ${sides}-gon closes`,
      source: "Proved by others, and computed here beside it",
      s: [r, 0],
      zoom: 6,
    },
  ];
}

/** The landmark that lies at s, but for rounding. */
export const landmarkAt = (all: readonly Landmark[], [x, y]: Uv): Landmark | undefined =>
  all.find(({ s }) => Math.hypot(s[0] - x, s[1] - y) < 1e-9);
