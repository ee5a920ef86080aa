/** The words of the page, each in a sentence or two: for help, and where they stand. */

export interface Word {
  word: string;
  means: string;
  /** The lesson that it leads to. */
  lesson?: string;
}

/** Words that explain themselves where they stand. */
export type TermName = "proved" | "looks whole" | "gap" | "u and v" | "the map of morphs" | "M";

export const WORDS: readonly Word[] = [
  {
    word: "shape",
    means:
      "What a list of maps that shrink agrees on: the one figure that is made of its own copies. In books: the attractor.",
    lesson: "e12",
  },
  {
    word: "map",
    means: "A rule that makes a smaller copy: turned, moved, stretched, perhaps mirrored.",
    lesson: "e13",
  },
  { word: "piece", means: "The copy of the whole shape that one map makes." },
  {
    word: "in one piece",
    means: "One can go from each piece to every other over pieces that share a point.",
    lesson: "e3",
  },
  {
    word: "proved",
    means:
      "There is a reason that does not depend on how closely one looks, and another program can check it.",
    lesson: "e4",
  },
  {
    word: "looks whole",
    means: "The pieces come nearer to each other than can be told apart; that they meet is not proved.",
    lesson: "e5",
  },
  {
    word: "gap",
    means:
      "The widest step that cannot be avoided on a walk over all pieces. It is 0 exactly when the shape is in one piece.",
    lesson: "e9",
  },
  {
    word: "1/600",
    means: "The fineness ε of a verdict: a gap below this part of the shape’s size is not told from none.",
    lesson: "e5",
  },
  {
    word: "u and v",
    means:
      "How far the turning and stretching of the maps has gone from A to B (u), and how far their places have (v). At 0, 0 it is A, at 1, 1 it is B.",
    lesson: "e7",
  },
  {
    word: "the map of morphs",
    means:
      "Every point is a shape between A and B: u, across, says how far its maps have turned and stretched, v, up, how far they have moved. It is pale where the shape is in one piece. In books: the connectedness locus.",
    lesson: "e7",
  },
  { word: "path", means: "The way from A to B on that map: what is played.", lesson: "e7" },
  {
    word: "M",
    means: "The same map for all shapes of two equal pieces, one for each complex number s of size below 1.",
    lesson: "e8",
  },
  {
    word: "address",
    means: "The digits that lead to a piece: 13 is piece 3 of piece 1.",
    lesson: "e16",
  },
];
