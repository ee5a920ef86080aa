/**
 * The course: its units and their lessons, in order. A new lesson is a folder with its `page.tsx`, an entry here, and
 * one in `thumbs.tsx`: its number follows from its place. Addresses (`#learn/e7`) stay as they were given out.
 */
import { type Figure, type Row, thumbFrom } from "../figure";

export interface Lesson extends Figure {
  /** How long it takes, about. */
  minutes: number;
  /** The lessons that it builds on. */
  after: readonly string[];
  /** The figures of the papers that show the same. */
  figures: readonly string[];
  /** Words that it explains or rests on, for whoever looks for one. */
  words: string;
}

/** A unit of the course. */
export interface Unit extends Row {
  figures: readonly Lesson[];
}

interface LessonEntry extends Omit<Figure, "number" | "short" | "also" | "thumb"> {
  minutes: number;
  words: string;
  after?: readonly string[];
  figures?: readonly string[];
}

interface UnitEntry {
  id: string;
  title: string;
  /** What one knows after it, in a sentence. */
  about: string;
  lessons: readonly LessonEntry[];
}

const COURSE: readonly UnitEntry[] = [
  {
    id: "copies",
    title: "Shapes made of themselves",
    about: "A few maps that shrink, and the one shape that they agree on.",
    lessons: [
      {
        id: "e12",
        title: "Start from anything",
        about: "Three small copies, again and again: does it matter what one begins with?",
        minutes: 5,
        words: "Sierpinski gasket triangle, Hutchinson operator, attractor, iterate, photograph",
        load: () => import("./lesson-12/page"),
      },
      {
        id: "e13",
        title: "Four maps, one fern",
        about: "Which map makes which part, and what is lost when one is left out.",
        minutes: 5,
        words: "Barnsley fern, leaf, plant, affine map, matrix",
        after: ["e12"],
        load: () => import("./lesson-13/page"),
      },
      {
        id: "e14",
        title: "Why maps must shrink",
        about: "Again and again the same map: from which scale on does everything come home?",
        minutes: 5,
        words: "contraction, contractive, scale factor, fixed point, Banach, limit, converge, power",
        after: ["e12"],
        load: () => import("./lesson-14/page"),
      },
    ],
  },
  {
    id: "chaos-game",
    title: "The chaos game",
    about: "The same shape by throwing dice, and a name for each of its points.",
    lessons: [
      {
        id: "e2",
        title: "The chaos game, thrown by hand",
        about: "Half of the way to a corner, at random: what never gets a mark?",
        minutes: 5,
        words: "Sierpinski gasket triangle, random, chance, dice, probability, Barnsley",
        load: () => import("./lesson-2/page"),
      },
      {
        id: "e16",
        title: "Where is 1(2)?",
        about: "A name of digits for every point, and two names for some.",
        minutes: 6,
        words: "address, code space, digits, symbolic, point, Hutchinson",
        after: ["e2"],
        figures: ["d1", "d2"],
        load: () => import("./lesson-16/page"),
      },
      {
        id: "e31",
        title: "Reach the cell",
        about: "You choose each throw: in how few can you land in the framed cell?",
        minutes: 6,
        words: "game, target, chaos game, address, digits, orbit, inverse map, Devaney",
        after: ["e2", "e16"],
        load: () => import("./lesson-31/page"),
      },
      {
        id: "e15",
        title: "Uneven dice",
        about: "Load the die: the same shape, in another shade.",
        minutes: 7,
        words: "weight, probability, chance, measure, density, fern, Elton",
        after: ["e2"],
        load: () => import("./lesson-15/page"),
      },
    ],
  },
  {
    id: "touching",
    title: "Touching",
    about: "When two pieces meet, when they are only near, and why a picture cannot tell.",
    lessons: [
      {
        id: "e1",
        title: "Two pieces that touch",
        about: "What touching means, and how little it takes to part.",
        minutes: 5,
        words: "gasket, connected, one piece, falls apart, gap, common point, lens, zoom, Hata",
        load: () => import("./lesson-1/page"),
      },
      {
        id: "e5",
        title: "What pixels hide",
        about: "The same shape, connected or not: it depends on the picture.",
        minutes: 6,
        words: "resolution, picture, raster, buffer, computer, error, one piece, in pieces",
        after: ["e1"],
        figures: ["2", "table-1"],
        load: () => import("./lesson-5/page"),
      },
    ],
  },
  {
    id: "overlap-graph",
    title: "The overlap graph",
    about:
      "A drawing of dots and lines that says whether a shape is in one piece, and how far it is from it.",
    lessons: [
      {
        id: "e3",
        title: "Dots and lines: the overlap graph",
        about: "A dot for each piece, a line where two touch: that is all it takes.",
        minutes: 6,
        words:
          "graph, connected, one piece, falls apart, holds together, Koch curve, Hata, neighbour, network",
        after: ["e1"],
        figures: ["2"],
        load: () => import("./lesson-3/page"),
      },
      {
        id: "e9",
        title: "Why three differs from two",
        about: "Two pieces meet and the third stands alone: what is the gap?",
        minutes: 6,
        words: "gap, spanning tree, distance, bottleneck, one piece, in pieces, apart",
        after: ["e3"],
        load: () => import("./lesson-9/page"),
      },
    ],
  },
  {
    id: "dimension",
    title: "Dimension",
    about: "How much room a shape takes, as a number that need not be whole.",
    lessons: [
      {
        id: "e17",
        title: "Counting boxes",
        about: "A line is 1, a square is 2: what is a gasket?",
        minutes: 7,
        words:
          "box counting, fractal dimension, Moran, Hausdorff, gasket, carpet, Cantor dust, logarithm, power",
        load: () => import("./lesson-17/page"),
      },
      {
        id: "e18",
        title: "How rough is a curve?",
        about: "A zigzag made of zigzags: when is it more than a line?",
        minutes: 7,
        words: "fractal function, interpolation, coast, mountain, roughness, Barnsley, graph of a function",
        after: ["e17"],
        figures: ["c1"],
        load: () => import("./lesson-18/page"),
      },
      {
        id: "e29",
        title: "A tent, a hill, a cloud",
        about: "Copies of copies on a tent: when is what they make smooth?",
        minutes: 6,
        words: "Takagi, parabola, Archimedes, blancmange, derivative, slope, smooth, function",
        after: ["e18"],
        figures: ["c1"],
        load: () => import("./lesson-29/page"),
      },
    ],
  },
  {
    id: "turning",
    title: "Turning",
    about: "What it takes to lead one shape into another without squashing it on the way.",
    lessons: [
      {
        id: "e6",
        title: "Half-way round: why polar",
        about: "Blend six numbers, and a turning piece vanishes on the way.",
        minutes: 6,
        words: "polar decomposition, rotation, matrix, determinant, interpolation, angle, morph",
        figures: ["3"],
        load: () => import("./lesson-6/page"),
      },
      {
        id: "e10",
        title: "The wrong pairing",
        about: "Which piece becomes which decides whether a morph can hold together.",
        minutes: 7,
        words: "correspondence, matching, permutation, morph, dragon, falls apart",
        after: ["e6"],
        load: () => import("./lesson-10/page"),
      },
    ],
  },
  {
    id: "map-of-morphs",
    title: "The map of morphs",
    about: "All in-betweens of two shapes on one map, and the ways across it that hold together.",
    lessons: [
      {
        id: "e20",
        title: "Reading a map",
        about: "Every point is a shape: what do the colours claim, and what do they leave open?",
        minutes: 7,
        words: "connectedness locus, parameter, u, v, border, bisection, halving, one piece, falls apart",
        after: ["e1"],
        figures: ["7"],
        load: () => import("./lesson-20/page"),
      },
      {
        id: "e7",
        title: "Straight on, or led",
        about: "Find where a morph breaks, then lead it round.",
        minutes: 7,
        words: "path, way, morph, falls apart, holds together, dragon, terdragon, connectedness locus",
        after: ["e6"],
        figures: ["5", "6", "7"],
        load: () => import("./lesson-7/page"),
      },
    ],
  },
  {
    id: "set-m",
    title: "The set M",
    about: "The map of all shapes of two equal pieces.",
    lessons: [
      {
        id: "e8",
        title: "One number, one shape: the set M",
        about: "All shapes of two equal pieces on one map: one piece, or dust.",
        minutes: 7,
        words: "Mandelbrot, complex number, Barnsley Harrington, dust, twin-dragon, connectedness locus",
        after: ["e1"],
        load: () => import("./lesson-8/page"),
      },
      {
        id: "e26",
        title: "Too small, too large",
        about: "One number, the dimension, draws a circle inside M and a circle around the rest of it.",
        minutes: 6,
        words: "dimension, Moran, complex number, area, inequality, bound",
        after: ["e17", "e8"],
        load: () => import("./lesson-26/page"),
      },
      {
        id: "e25",
        title: "A walk along the edge of M",
        about: "Pieces of one size, turned a little more at every step: whole, dust, and whole again?",
        minutes: 6,
        words: "complex number, angle, circle, boundary, twin-dragon",
        after: ["e8"],
        load: () => import("./lesson-25/page"),
      },
    ],
  },
  {
    id: "proofs",
    title: "Proofs",
    about: "What a machine can prove about infinitely many pieces, and what it has to leave open.",
    lessons: [
      {
        id: "e4",
        title: "A bound that closes in",
        about: "How a machine proves pieces apart, and why it cannot prove them together.",
        minutes: 7,
        words: "proof, bound, inequality, Cantor dust, interval, algorithm",
        after: ["e1", "e3"],
        figures: ["1"],
        load: () => import("./lesson-4/page"),
      },
      {
        id: "e21",
        title: "Two curves that must cross",
        about: "When crossing proves touching, and when it is only a picture.",
        minutes: 6,
        words: "proof, trap, Jordan curve theorem, crossing, topology",
        after: ["e1"],
        load: () => import("./lesson-21/page"),
      },
      {
        id: "e30",
        title: "A ruler of one’s own",
        about: "A map that makes things longer, and brings all of them home: does it shrink?",
        minutes: 7,
        words: "norm, metric, contraction, joint spectral radius, linear map, shear, Rota Strang, eigenvalue",
        after: ["e14"],
        load: () => import("./lesson-30/page"),
      },
    ],
  },
  {
    id: "bending",
    title: "Bending",
    about: "Pull one point of a shape, and decide which of its parts answer.",
    lessons: [
      {
        id: "e11",
        title: "Plain or fractal?",
        about: "Lift one point of a shape: what do the far corners do?",
        minutes: 6,
        words: "deformation, shuffle, address, code, grid, displacement",
        figures: ["d4"],
        load: () => import("./lesson-11/page"),
      },
      {
        id: "e22",
        title: "Every level, or only the whole",
        about: "Two numbers lead from a plain bend to a fractal one: who answers, and how loudly?",
        minutes: 6,
        words: "deformation, locality, roughness, geometric series, code, shuffle",
        after: ["e11"],
        figures: ["d4"],
        load: () => import("./lesson-22/page"),
      },
    ],
  },
  {
    id: "leaves",
    title: "Leaves",
    about: "From a shape that one has to the few maps that make it.",
    lessons: [
      {
        id: "e23",
        title: "Cover the leaf",
        about: "Cover a leaf with small copies of itself: how good is what they make?",
        minutes: 10,
        words: "collage theorem, inverse problem, Hausdorff distance, geometric series, fit",
        after: ["e12"],
        figures: ["c7"],
        load: () => import("./lesson-23/page"),
      },
      {
        id: "e27",
        title: "A leaf in few numbers",
        about: "Four maps are a leaf: how many digits of them does one have to keep?",
        minutes: 6,
        words: "compression, rounding, digits, bytes, error, geometric series",
        after: ["e23"],
        load: () => import("./lesson-27/page"),
      },
    ],
  },
  {
    id: "space",
    title: "Space",
    about: "Shapes of space, and what is left of them in a shadow.",
    lessons: [
      {
        id: "e24",
        title: "Shadows of the sponge",
        about: "What is full of holes may throw a shadow without any.",
        minutes: 6,
        words: "Menger sponge, tetrahedron, projection, 3D, solid, cube, hexagon",
        figures: ["s35"],
        load: () => import("./lesson-24/page"),
      },
      {
        id: "e28",
        title: "To turn a shape, turn its maps",
        about: "A shape of infinitely many points is turned by a few numbers: which ones change?",
        minutes: 6,
        words: "rotation, conjugate, matrix, tetrahedron, 3D, solid, move",
        figures: ["s2"],
        load: () => import("./lesson-28/page"),
      },
    ],
  },
];

/** The units that have lessons, each lesson with its number. */
export const UNITS: readonly Unit[] = numbered(COURSE);

/** All lessons in order. */
export const LESSONS: readonly Lesson[] = UNITS.flatMap(({ figures }) => figures);

function numbered(course: readonly UnitEntry[]): Unit[] {
  let number = 0;
  return course
    .filter(({ lessons }) => lessons.length > 0)
    .map(({ id, title, about, lessons }) => ({
      id,
      name: title,
      title,
      about,
      figures: lessons.map(({ after = [], figures = [], ...lesson }) => {
        number++;
        return {
          ...lesson,
          after,
          figures,
          number: `Lesson ${number}`,
          short: String(number),
          thumb: () => thumbFrom(import("./thumbs"), lesson.id),
        };
      }),
    }));
}
