/**
 * All figures and lessons: the only place that names them. A new one is a folder with its `page.tsx` and its
 * `thumb.tsx`, and an entry here. What a folder holds is fetched when it is shown, so that this list can be read by
 * anybody, tests without a browser too.
 */
import type { ComponentType } from "preact";
import type { Heading } from "./kit/frame/frame";

export interface Figure {
  /** The part of the address behind `#figures/`; further ones lead to the same page. */
  id: string;
  also?: readonly string[];
  /** As the paper counts. */
  number: string;
  /** The same in the row of all figures. */
  short: string;
  title: string;
  /** One line for the index. */
  about: string;
  load(): Promise<PageModule>;
  thumb(): Promise<ThumbModule>;
}

export interface PageModule extends Needing {
  Page: ComponentType<Heading>;
}

/** A small picture, made by the same parts as the figure itself. */
export interface ThumbModule extends Needing {
  Thumb: ComponentType;
}

interface Needing {
  /** What must be there before it is shown. */
  needs?: readonly (() => Promise<unknown>)[];
}

/** The figures of a paper, or the lessons. */
export interface Row {
  id: string;
  name: string;
  title: string;
  about: string;
  figures: readonly Figure[];
}

export const ROWS: readonly Row[] = [
  {
    id: "from-the-paper",
    name: "Figures",
    title: "Shapes that turn into others",
    about:
      "The figures and the table of “Linear Fractal Shape Interpolation” by Brandon Burch and John C. Hart (Graphics Interface 1997), as pages in which everything moves. All of it is computed here, while you look.",
    figures: [
      {
        id: "1",
        number: "Figure 1",
        short: "1",
        title: "When is a shape proved to be in pieces?",
        about: "Barnsley’s test on a Cantor dust that closes at one half.",
        load: () => import("./burch-hart/figure-1/page"),
        thumb: () => import("./burch-hart/figure-1/thumb"),
      },
      {
        id: "2",
        number: "Figure 2",
        short: "2",
        title: "Connected, as far as pixels tell",
        about: "The index buffer: pixels collide, and a graph gains its edges.",
        load: () => import("./burch-hart/figure-2/page"),
        thumb: () => import("./burch-hart/figure-2/thumb"),
      },
      {
        id: "3",
        also: ["4"],
        number: "Figures 3 and 4",
        short: "3, 4",
        title: "Two ways to turn a map around",
        about: "Number by number a map collapses on the way; turned, it keeps its size.",
        load: () => import("./burch-hart/figures-3-and-4/page"),
        thumb: () => import("./burch-hart/figures-3-and-4/thumb"),
      },
      {
        id: "5",
        number: "Figure 5",
        short: "5",
        title: "The straight way from dragon to gasket",
        about: "A morph that nobody watches falls apart.",
        load: () => import("./burch-hart/figure-5/page"),
        thumb: () => import("./burch-hart/figure-5/thumb"),
      },
      {
        id: "6",
        number: "Figure 6",
        short: "6",
        title: "The way that holds together",
        about: "The same morph, led along a path on which the shape stays in one piece.",
        load: () => import("./burch-hart/figure-6/page"),
        thumb: () => import("./burch-hart/figure-6/thumb"),
      },
      {
        id: "7",
        number: "Figure 7",
        short: "7",
        title: "The map of all in‑betweens",
        about: "The connectedness locus, with both ways drawn on it.",
        load: () => import("./burch-hart/figure-7/page"),
        thumb: () => import("./burch-hart/figure-7/thumb"),
      },
      {
        id: "table-1",
        number: "Table 1",
        short: "Table 1",
        title: "How well do pixels tell?",
        about: "The index buffer measured at four resolutions, here and now.",
        load: () => import("./burch-hart/table-1/page"),
        thumb: () => import("./burch-hart/table-1/thumb"),
      },
    ],
  },
  {
    id: "deformation",
    name: "Figures of the deformation",
    title: "Shapes that are bent at every scale",
    about:
      "The figures of “Fractal Deformation Using Displacement Vectors Based on Extended Iterated Shuffle Transformation” by Tadahiro Fujimoto, Yoshio Ohno, Kazunobu Muraoka and Norishige Chiba: pull a grid, and every part of the shape answers.",
    figures: [
      {
        id: "d1",
        number: "Deformation, Figure 1",
        short: "1",
        title: "Every point has a code",
        about: "Letter by letter into a line and a square, by halves and by thirds.",
        load: () => import("./fujimoto/figure-1/page"),
        thumb: () => import("./fujimoto/figure-1/thumb"),
      },
      {
        id: "d2",
        number: "Deformation, Figure 2",
        short: "2",
        title: "Codes on a gasket",
        about: "The letters are its maps, and where pieces overlap a place has several codes.",
        load: () => import("./fujimoto/figure-2/page"),
        thumb: () => import("./fujimoto/figure-2/thumb"),
      },
      {
        id: "d3",
        number: "Deformation, Figure 3",
        short: "3",
        title: "A picture, shuffled",
        about: "Letters in reverse order: what detail and locality do to colours.",
        load: () => import("./fujimoto/figure-3/page"),
        thumb: () => import("./fujimoto/figure-3/thumb"),
      },
      {
        id: "d4",
        number: "Deformation, Figure 4",
        short: "4",
        title: "One pull, and every triangle answers",
        about: "The gasket bent in eight ways, and the slide from plain to fractal.",
        load: () => import("./fujimoto/figure-4/page"),
        thumb: () => import("./fujimoto/figure-4/thumb"),
      },
      {
        id: "d5",
        number: "Deformation, Figure 5",
        short: "5",
        title: "A fern in the wind",
        about: "Every leaf sways about its own stem.",
        load: () => import("./fujimoto/figure-5/page"),
        thumb: () => import("./fujimoto/figure-5/thumb"),
      },
      {
        id: "d6",
        number: "Deformation, Figure 6",
        short: "6",
        title: "A dragon that winds in its tips",
        about: "Drawn at one corner, with colours that tell which parts answer alike.",
        load: () => import("./fujimoto/figure-6/page"),
        thumb: () => import("./fujimoto/figure-6/thumb"),
      },
    ],
  },
  {
    id: "rough-curves",
    name: "Figures of rough curves",
    title: "Rough curves from a few maps",
    about:
      "The figures and tables of “On Approximating Rough Curves With Fractal Functions” by Wayne O. Cochran, John C. Hart and Patrick J. Flynn: functions made of copies of themselves, the search for their maps, and the outline of a leaf.",
    figures: [
      {
        id: "c1",
        number: "Rough curves, Figure 1",
        short: "1",
        title: "Through three points, as rough as you like",
        about: "Drag the points and turn the roughness: a curve made of two copies of itself.",
        load: () => import("./cochran/figure-1/page"),
        thumb: () => import("./cochran/figure-1/thumb"),
      },
      {
        id: "c2",
        also: ["ct1"],
        number: "Rough curves, Figure 2 and Table 1",
        short: "2, T1",
        title: "A mountain range of ten numbers",
        about: "Two maps, and a step between them that no print shows.",
        load: () => import("./cochran/figure-2/page"),
        thumb: () => import("./cochran/figure-2/thumb"),
      },
      {
        id: "ct2",
        number: "Rough curves, Table 2",
        short: "T2",
        title: "Points that vote for their maps",
        about: "Millions of votes heap up over the two maps, and over their echoes.",
        load: () => import("./cochran/table-2/page"),
        thumb: () => import("./cochran/table-2/thumb"),
      },
      {
        id: "c3",
        number: "Rough curves, Figure 3",
        short: "3",
        title: "One curve in space, three shadows",
        about: "Turn a curve through a gasket, and see what its shadows hide.",
        load: () => import("./cochran/figure-3/page"),
        thumb: () => import("./cochran/figure-3/thumb"),
      },
      {
        id: "c4",
        number: "Rough curves, Figure 4",
        short: "4",
        title: "Rough, and no copy of itself",
        about: "The view from above: its middle third is the whole, its sides are not.",
        load: () => import("./cochran/figure-4/page"),
        thumb: () => import("./cochran/figure-4/thumb"),
      },
      {
        id: "c5",
        number: "Rough curves, Figure 5",
        short: "5",
        title: "Heaps of votes, seen from four sides",
        about: "A hundred clusters in a space of five dimensions that is nearly flat.",
        load: () => import("./cochran/figure-5/page"),
        thumb: () => import("./cochran/figure-5/thumb"),
      },
      {
        id: "c6",
        also: ["ct3"],
        number: "Rough curves, Figure 6 and Table 3",
        short: "6, T3",
        title: "Seven maps, or eleven",
        about: "Parts that copy parts, how far they are off, and an open question answered.",
        load: () => import("./cochran/figure-6/page"),
        thumb: () => import("./cochran/figure-6/thumb"),
      },
      {
        id: "c7",
        number: "Rough curves, Figure 7",
        short: "7",
        title: "A leaf in few numbers",
        about: "The paper’s fits with their gaps, and a closed curve of as many numbers.",
        load: () => import("./cochran/figure-7/page"),
        thumb: () => import("./cochran/figure-7/thumb"),
      },
    ],
  },
  {
    id: "in-space",
    name: "Figures of space",
    title: "Shapes in space, moved by their parameters",
    about:
      "The figures of “IFS Fractal Animation” by Nevin M. Darwish and Reda Abd-El-Wahab, rebuilt, as their print is cut off: to turn a shape is to turn its maps, and each frame is a set of parameters.",
    figures: [
      {
        id: "s1",
        number: "Space, Figure i",
        short: "i",
        title: "A triangle hung up in space",
        about: "Three maps, and two sets of parameters for one picture.",
        load: () => import("./darwish/figure-i/page"),
        thumb: () => import("./darwish/figure-i/thumb"),
      },
      {
        id: "s2",
        number: "Space, Figure ii",
        short: "ii",
        title: "Turned by its parameters",
        about: "No point is turned: the three maps are, and the picture is the same.",
        load: () => import("./darwish/figure-ii/page"),
        thumb: () => import("./darwish/figure-ii/thumb"),
      },
      {
        id: "s3",
        number: "Space, Figure iii",
        short: "iii",
        title: "Carried before the eye",
        about: "The eye stays at the origin, and translations say where a map stands.",
        load: () => import("./darwish/figure-iii/page"),
        thumb: () => import("./darwish/figure-iii/thumb"),
      },
      {
        id: "s4",
        number: "Space, Figure iv",
        short: "iv",
        title: "Turned ten thousand times",
        about: "Parameters of parameters of parameters: how far does rounding get?",
        load: () => import("./darwish/figure-iv/page"),
        thumb: () => import("./darwish/figure-iv/thumb"),
      },
      {
        id: "s5",
        number: "Space, Figure v",
        short: "v",
        title: "A pyramid of five halves",
        about: "Fifteen units before the eye, or thirty, as its print says.",
        load: () => import("./darwish/figure-v/page"),
        thumb: () => import("./darwish/figure-v/thumb"),
      },
      {
        id: "s6",
        number: "Space, Figure vi",
        short: "vi",
        title: "The pyramid, turned",
        about: "About itself, or about the eye, which loses sight of it.",
        load: () => import("./darwish/figure-vi/page"),
        thumb: () => import("./darwish/figure-vi/thumb"),
      },
      {
        id: "s7",
        number: "Space, Figure vii",
        short: "vii",
        title: "A landscape of parameters",
        about: "Ground, trees and clouds, each a list of maps, seen from the origin.",
        load: () => import("./darwish/figure-vii/page"),
        thumb: () => import("./darwish/figure-vii/thumb"),
      },
      {
        id: "s8",
        number: "Space, Figure viii",
        short: "viii",
        title: "The world turns",
        about: "One transform on the parameters of every object, and the eye stays where it is.",
        load: () => import("./darwish/figure-viii/page"),
        thumb: () => import("./darwish/figure-viii/thumb"),
      },
      {
        id: "s35",
        number: "Space, Section 3.5",
        short: "3.5",
        title: "A shadow that costs infinity",
        about: "Flatten a shape by ε, and watch which of its numbers run away.",
        load: () => import("./darwish/section-3-5/page"),
        thumb: () => import("./darwish/section-3-5/thumb"),
      },
      {
        id: "s9",
        number: "Space, the open question",
        short: "?",
        title: "The open question",
        about: "Is what two fractals share a fractal again? Once it is, and once it is proved not to be.",
        load: () => import("./darwish/open-question/page"),
        thumb: () => import("./darwish/open-question/thumb"),
      },
    ],
  },
  {
    id: "lessons",
    name: "Lessons",
    title: "Eleven lessons",
    about:
      "One idea a page, in order, for anyone who has never heard of any of this. Each shows a finished picture, then asks what you expect before it shows what is so.",
    figures: [
      {
        id: "e1",
        number: "Lesson 1",
        short: "1",
        title: "Two pieces that touch",
        about: "What touching means, and how little it takes to part.",
        load: () => import("./lessons/lesson-1/page"),
        thumb: () => import("./lessons/lesson-1/thumb"),
      },
      {
        id: "e2",
        number: "Lesson 2",
        short: "2",
        title: "The chaos game, thrown by hand",
        about: "Half of the way to a corner, at random: what never gets a mark?",
        load: () => import("./lessons/lesson-2/page"),
        thumb: () => import("./lessons/lesson-2/thumb"),
      },
      {
        id: "e3",
        number: "Lesson 3",
        short: "3",
        title: "Dots and lines: the overlap graph",
        about: "A dot for each piece, a line where two touch: that is all it takes.",
        load: () => import("./lessons/lesson-3/page"),
        thumb: () => import("./lessons/lesson-3/thumb"),
      },
      {
        id: "e4",
        number: "Lesson 4",
        short: "4",
        title: "A bound that closes in",
        about: "How a machine proves pieces apart, and why it cannot prove them together.",
        load: () => import("./lessons/lesson-4/page"),
        thumb: () => import("./lessons/lesson-4/thumb"),
      },
      {
        id: "e5",
        number: "Lesson 5",
        short: "5",
        title: "What pixels hide",
        about: "The same shape, connected or not: it depends on the picture.",
        load: () => import("./lessons/lesson-5/page"),
        thumb: () => import("./lessons/lesson-5/thumb"),
      },
      {
        id: "e6",
        number: "Lesson 6",
        short: "6",
        title: "Half-way round: why polar",
        about: "Blend six numbers, and a turning piece vanishes on the way.",
        load: () => import("./lessons/lesson-6/page"),
        thumb: () => import("./lessons/lesson-6/thumb"),
      },
      {
        id: "e7",
        number: "Lesson 7",
        short: "7",
        title: "Straight on, or led",
        about: "Find where a morph breaks, then lead it round.",
        load: () => import("./lessons/lesson-7/page"),
        thumb: () => import("./lessons/lesson-7/thumb"),
      },
      {
        id: "e8",
        number: "Lesson 8",
        short: "8",
        title: "One number, one shape: the set M",
        about: "All shapes of two equal pieces on one map: one piece, or dust.",
        load: () => import("./lessons/lesson-8/page"),
        thumb: () => import("./lessons/lesson-8/thumb"),
      },
      {
        id: "e9",
        number: "Lesson 9",
        short: "9",
        title: "Why three differs from two",
        about: "Two pieces meet and the third stands alone: what is the gap?",
        load: () => import("./lessons/lesson-9/page"),
        thumb: () => import("./lessons/lesson-9/thumb"),
      },
      {
        id: "e10",
        number: "Lesson 10",
        short: "10",
        title: "The wrong pairing",
        about: "Which piece becomes which decides whether a morph can hold together.",
        load: () => import("./lessons/lesson-10/page"),
        thumb: () => import("./lessons/lesson-10/thumb"),
      },
      {
        id: "e11",
        number: "Lesson 11",
        short: "11",
        title: "Plain or fractal?",
        about: "Lift one point of a shape: what do the far corners do?",
        load: () => import("./lessons/lesson-11/page"),
        thumb: () => import("./lessons/lesson-11/thumb"),
      },
    ],
  },
];

/** Where an address leads: one of a row of figures. */
export function find(id: string): { row: Row; index: number; figure: Figure } | null {
  const asked = id.toLowerCase();
  for (const row of ROWS) {
    const index = row.figures.findIndex((figure) => figure.id === asked || figure.also?.includes(asked));
    const figure = row.figures[index];
    if (figure) return { row, index, figure };
  }
  return null;
}
