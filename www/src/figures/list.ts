/**
 * All figures of the papers: the only place that names them; the lessons are in `lessons/course.ts`. A new one is a
 * folder with its `page.tsx`, an entry here, and one in `thumbs.tsx` of its paper. Pages and small pictures are fetched
 * when they are shown, so that this list can be read by anybody, tests without a browser too.
 */
import { type Figure, type Row, type Thumbs, thumbFrom } from "./figure";
import { LESSONS, type Lesson, UNITS } from "./lessons/course";

/** The figures of a paper, and where their small pictures are. */
interface Paper extends Omit<Row, "figures"> {
  thumbs: () => Promise<{ THUMBS: Thumbs }>;
  figures: readonly Omit<Figure, "thumb">[];
}

const PAPERS: readonly Paper[] = [
  {
    id: "from-the-paper",
    name: "Figures",
    paper: "Burch & Hart 1997",
    title: "Shapes that turn into others",
    about:
      "The figures and the table of “Linear Fractal Shape Interpolation” by Brandon Burch and John C. Hart (Graphics Interface 1997), as pages in which everything moves. All of it is computed here, while you look.",
    thumbs: () => import("./burch-hart/thumbs"),
    figures: [
      {
        id: "1",
        number: "Figure 1",
        short: "1",
        title: "When is a shape proved to be in pieces?",
        about: "Barnsley’s test on a Cantor dust that closes at one half.",
        load: () => import("./burch-hart/figure-1/page"),
      },
      {
        id: "2",
        number: "Figure 2",
        short: "2",
        title: "Connected, as far as pixels tell",
        about: "The index buffer: pixels collide, and a graph gains its edges.",
        load: () => import("./burch-hart/figure-2/page"),
      },
      {
        id: "3",
        also: ["4"],
        number: "Figures 3 and 4",
        short: "3, 4",
        title: "Two ways to turn a map around",
        about: "Number by number a map collapses on the way; turned, it keeps its size.",
        load: () => import("./burch-hart/figures-3-and-4/page"),
      },
      {
        id: "5",
        number: "Figure 5",
        short: "5",
        title: "The straight way from dragon to gasket",
        about: "A morph that nobody watches falls apart.",
        load: () => import("./burch-hart/figure-5/page"),
      },
      {
        id: "6",
        number: "Figure 6",
        short: "6",
        title: "The way that holds together",
        about: "The same morph, led along a path on which the shape stays in one piece.",
        load: () => import("./burch-hart/figure-6/page"),
      },
      {
        id: "7",
        number: "Figure 7",
        short: "7",
        title: "The map of all in‑betweens",
        about: "The connectedness locus, with both ways drawn on it.",
        load: () => import("./burch-hart/figure-7/page"),
      },
      {
        id: "table-1",
        number: "Table 1",
        short: "Table 1",
        title: "How well do pixels tell?",
        about: "The index buffer measured at four resolutions, here and now.",
        load: () => import("./burch-hart/table-1/page"),
      },
      {
        id: "section-7",
        number: "Section 7.1",
        short: "7.1",
        title: "Shapes made of one another",
        about: "A graph says which shape copies which, and two such graphs are morphed.",
        load: () => import("./burch-hart/section-7/page"),
      },
    ],
  },
  {
    id: "deformation",
    name: "Figures of the deformation",
    paper: "Fujimoto, Ohno, Muraoka & Chiba",
    title: "Shapes that are bent at every scale",
    about:
      "The figures of “Fractal Deformation Using Displacement Vectors Based on Extended Iterated Shuffle Transformation” by Tadahiro Fujimoto, Yoshio Ohno, Kazunobu Muraoka and Norishige Chiba: pull a grid, and every part of the shape answers.",
    thumbs: () => import("./fujimoto/thumbs"),
    figures: [
      {
        id: "d1",
        number: "Deformation, Figure 1",
        short: "1",
        title: "Every point has a code",
        about: "Letter by letter into a line and a square, each side cut in two or in three.",
        load: () => import("./fujimoto/figure-1/page"),
      },
      {
        id: "d2",
        number: "Deformation, Figure 2",
        short: "2",
        title: "Codes on a gasket",
        about: "The letters are its maps, and where pieces overlap a place has several codes.",
        load: () => import("./fujimoto/figure-2/page"),
      },
      {
        id: "d3",
        number: "Deformation, Figure 3",
        short: "3",
        title: "A picture, shuffled",
        about: "Letters in reverse order: what detail and locality do to colours.",
        load: () => import("./fujimoto/figure-3/page"),
      },
      {
        id: "d4",
        number: "Deformation, Figure 4",
        short: "4",
        title: "One pull, and every triangle answers",
        about: "The gasket bent in eight ways, and the slide from plain to fractal.",
        load: () => import("./fujimoto/figure-4/page"),
      },
      {
        id: "d5",
        number: "Deformation, Figure 5",
        short: "5",
        title: "A fern in the wind",
        about: "Every leaf sways about its own stem.",
        load: () => import("./fujimoto/figure-5/page"),
      },
      {
        id: "d6",
        number: "Deformation, Figure 6",
        short: "6",
        title: "A dragon that winds in its tips",
        about: "Drawn at one corner, with colours that tell which parts answer alike.",
        load: () => import("./fujimoto/figure-6/page"),
      },
      {
        id: "d53",
        number: "Deformation, section 5.3",
        short: "5.3",
        title: "A sponge, bent at every scale",
        about: "The same in space, with a lattice around the shape; and what a connected shuffle would need.",
        load: () => import("./fujimoto/section-5-3/page"),
      },
    ],
  },
  {
    id: "rough-curves",
    name: "Figures of rough curves",
    paper: "Cochran, Hart & Flynn",
    title: "Rough curves from a few maps",
    about:
      "The figures and tables of “On Approximating Rough Curves With Fractal Functions” by Wayne O. Cochran, John C. Hart and Patrick J. Flynn: functions made of copies of themselves, the search for their maps, and the outline of a leaf.",
    thumbs: () => import("./cochran/thumbs"),
    figures: [
      {
        id: "c1",
        number: "Rough curves, Figure 1",
        short: "1",
        title: "Through three points, as rough as you like",
        about: "Drag the points and turn the roughness: a curve made of two copies of itself.",
        load: () => import("./cochran/figure-1/page"),
      },
      {
        id: "c24",
        number: "Rough curves, Section 2.4",
        short: "2.4",
        title: "Curves that fold back",
        about: "Three points of the plane, and copies in which x and y answer to each other, or do not.",
        load: () => import("./cochran/section-2-4/page"),
      },
      {
        id: "c2",
        also: ["ct1"],
        number: "Rough curves, Figure 2 and Table 1",
        short: "2, T1",
        title: "A mountain range of ten numbers",
        about: "Two maps, and a step between them that no print shows.",
        load: () => import("./cochran/figure-2/page"),
      },
      {
        id: "ct2",
        number: "Rough curves, Table 2",
        short: "T2",
        title: "Points that vote for their maps",
        about: "Millions of votes heap up over the two maps, and over their echoes.",
        load: () => import("./cochran/table-2/page"),
      },
      {
        id: "c3",
        number: "Rough curves, Figure 3",
        short: "3",
        title: "One curve in space, three shadows",
        about: "Turn a curve through a gasket, and see what its shadows hide.",
        load: () => import("./cochran/figure-3/page"),
      },
      {
        id: "c4",
        number: "Rough curves, Figure 4",
        short: "4",
        title: "Rough, and no copy of itself",
        about: "The view from above: its middle third is the whole, its sides are not.",
        load: () => import("./cochran/figure-4/page"),
      },
      {
        id: "c5",
        number: "Rough curves, Figure 5",
        short: "5",
        title: "Heaps of votes, seen from four sides",
        about: "A hundred clusters in a space of five dimensions that is nearly flat.",
        load: () => import("./cochran/figure-5/page"),
      },
      {
        id: "c6",
        also: ["ct3"],
        number: "Rough curves, Figure 6 and Table 3",
        short: "6, T3",
        title: "Seven maps, or eleven",
        about: "Parts that copy parts, how far they are off, and an open question answered.",
        load: () => import("./cochran/figure-6/page"),
      },
      {
        id: "c7",
        number: "Rough curves, Figure 7",
        short: "7",
        title: "A leaf in few numbers",
        about: "The paper’s fits with their gaps, and a closed curve of as many numbers.",
        load: () => import("./cochran/figure-7/page"),
      },
      {
        id: "c43",
        number: "Rough curves, Section 4.3",
        short: "4.3",
        title: "From pixels to maps, step by step",
        about: "A bitmap, its boundary, 261 points, and two fits: every step of the paper’s way to its leaf.",
        load: () => import("./cochran/figure-7-steps/page"),
      },
    ],
  },
  {
    id: "in-space",
    name: "Figures of space",
    paper: "Darwish & Abd-El-Wahab",
    title: "Shapes in space, moved by their parameters",
    about:
      "The figures of “IFS Fractal Animation” by Nevin M. Darwish and Reda Abd-El-Wahab, as printed, or rebuilt where their print is cut off: to turn a shape is to turn its maps, and each frame is a set of parameters.",
    thumbs: () => import("./darwish/thumbs"),
    figures: [
      {
        id: "s1",
        number: "Space, Figure i",
        short: "i",
        title: "A triangle in space",
        about: "Three maps, and two sets of parameters for one picture.",
        load: () => import("./darwish/figure-i/page"),
      },
      {
        id: "s2",
        number: "Space, Figure ii",
        short: "ii",
        title: "Turned by its parameters",
        about: "No point is turned: the three maps are, and the picture is the same.",
        load: () => import("./darwish/figure-ii/page"),
      },
      {
        id: "s3",
        number: "Space, Figure iii",
        short: "iii",
        title: "Carried before the eye",
        about: "The eye stays at the origin, and translations say where a map stands.",
        load: () => import("./darwish/figure-iii/page"),
      },
      {
        id: "s4",
        number: "Space, Figure iv",
        short: "iv",
        title: "Turned ten thousand times",
        about: "The triangle that is printed whole; turned again and again, how far does rounding get?",
        load: () => import("./darwish/figure-iv/page"),
      },
      {
        id: "s5",
        number: "Space, Figure v",
        short: "v",
        title: "A pyramid of five small ones",
        about: "Thirty units before the eye, as its print says, or as near as you like.",
        load: () => import("./darwish/figure-v/page"),
      },
      {
        id: "s6",
        number: "Space, Figure vi",
        short: "vi",
        title: "The pyramid, turned",
        about: "About itself, or about the eye, which loses sight of it.",
        load: () => import("./darwish/figure-vi/page"),
      },
      {
        id: "s7",
        number: "Space, Figure vii",
        short: "vii",
        title: "A landscape of parameters",
        about: "Ground, trees and clouds, each a list of maps, seen from the origin.",
        load: () => import("./darwish/figure-vii/page"),
      },
      {
        id: "s8",
        number: "Space, Figure viii",
        short: "viii",
        title: "The world turns",
        about: "One transform on the parameters of every object, and the eye stays where it is.",
        load: () => import("./darwish/figure-viii/page"),
      },
      {
        id: "s34",
        number: "Space, Section 3.4",
        short: "3.4",
        title: "One formula for every move",
        about: "Drag a shape of the plane: none of its points is moved, all of its parameters are.",
        load: () => import("./darwish/section-3-4/page"),
      },
      {
        id: "s35",
        number: "Space, Section 3.5",
        short: "3.5",
        title: "A shadow that costs infinity",
        about: "Flatten a shape by ε, and watch which of its numbers run away.",
        load: () => import("./darwish/section-3-5/page"),
      },
      {
        id: "s9",
        number: "Space, the open question",
        short: "?",
        title: "The open question",
        about: "Is what two fractals share a fractal again? Once it is, and once it is proved not to be.",
        load: () => import("./darwish/open-question/page"),
      },
      {
        id: "s10",
        number: "Space, the open question on a grid",
        short: "? II",
        title: "What two shapes of one grid share",
        about: "Slide one over the other by a fraction: what they share is made of a few kinds of pieces.",
        load: () => import("./darwish/shared-grid/page"),
      },
    ],
  },
];

export const ROWS: readonly Row[] = PAPERS.map(({ thumbs, figures, ...row }) => ({
  ...row,
  figures: figures.map((figure) => ({ ...figure, thumb: () => thumbFrom(thumbs(), figure.id) })),
}));

/** Where an address leads: one of a row of figures, or of a unit of the course. */
export function find(id: string): { row: Row; figure: Figure } | null {
  const asked = id.toLowerCase();
  for (const row of [...ROWS, ...UNITS]) {
    const figure = row.figures.find((one) => one.id === asked || one.also?.includes(asked));
    if (figure) return { row, figure };
  }
  return null;
}

/** The lesson that a figure is, if it is one. */
export function lessonOf(figure: Figure): Lesson | undefined {
  return LESSONS.find(({ id }) => id === figure.id);
}

/** Where a figure or a lesson is. */
export function hrefOf(figure: Figure): string {
  return lessonOf(figure) ? `#learn/${figure.id}` : `#figures/${figure.id}`;
}

/** Those around it: a row of figures ends where its paper does, lessons go on to the next unit. */
export function neighbours({ row, figure }: { row: Row; figure: Figure }) {
  const all = lessonOf(figure) ? LESSONS : row.figures;
  const index = all.findIndex(({ id }) => id === figure.id);
  return { before: all[index - 1], next: all[index + 1] };
}

/** What tells of the same: the figures for a lesson, the lessons for a figure. */
export function related(figure: Figure): Figure[] {
  const lesson = lessonOf(figure);
  if (!lesson) return LESSONS.filter(({ figures }) => figures.includes(figure.id));
  return lesson.figures.flatMap((id) => find(id)?.figure ?? []);
}
