/** The words of the page, each in a sentence or two: for help, and where they stand. */

export interface Word {
  word: string;
  means: string;
  /** The lesson that it leads to. */
  lesson?: string;
}

/** Words that explain themselves where they stand. */
export type TermName = "proved" | "no gap seen" | "gap" | "u and v" | "the locus" | "M";

export const WORDS: readonly Word[] = [
  {
    word: "shape",
    means: "The one figure that is made of the copies its maps make of it. In books: the attractor.",
    lesson: "e12",
  },
  {
    word: "map",
    means: "A rule that makes a smaller copy: rotated, moved, stretched or mirrored.",
    lesson: "e13",
  },
  { word: "piece", means: "The copy of the full shape that one map makes." },
  {
    word: "in one piece",
    means: "You can go from each piece to every other through pieces that share a point.",
    lesson: "e3",
  },
  {
    word: "proved",
    means: "The reason holds at every magnification, and a separate program can check it.",
    lesson: "e4",
  },
  {
    word: "no gap seen",
    means: "The pieces come so close that no gap shows at this resolution. It is not proved that they meet.",
    lesson: "e5",
  },
  {
    word: "gap",
    means:
      "The widest step you cannot avoid when you walk over all pieces. It is 0 exactly when the shape is in one piece.",
    lesson: "e9",
  },
  {
    word: "1/600",
    means: "The resolution ε of a verdict: Frond does not see gaps below this fraction of the shape’s size.",
    lesson: "e5",
  },
  {
    word: "u and v",
    means:
      "u says how far the maps have turned and stretched from A to B, and v how far they have moved. A is at 0, 0 and B at 1, 1.",
    lesson: "e7",
  },
  {
    word: "the locus",
    means:
      "The picture of all shapes between A and B, one at each point: u runs to the right, v upwards. It is pale where the shape stays in one piece. In books: the connectedness locus.",
    lesson: "e7",
  },
  {
    word: "path",
    means: "The line from A to B across the locus. Playing the morph follows it.",
    lesson: "e7",
  },
  {
    word: "M",
    means: "The locus of all shapes with two equal pieces, one for each complex number s with |s| < 1.",
    lesson: "e8",
  },
  {
    word: "address",
    means: "The digits that lead to a piece: 13 is piece 3 of piece 1.",
    lesson: "e16",
  },
];
