/** The words of the page, each in a sentence or two: for help, and where they stand. */
import * as messages from "../messages";

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
    means: messages.oneFigureMadeCopies,
    lesson: "e12",
  },
  {
    word: "map",
    means: messages.ruleMakesSmallerCopy,
    lesson: "e13",
  },
  { word: "piece", means: messages.copyFullShapeOne },
  {
    word: "in one piece",
    means: messages.youCanGoFrom,
    lesson: "e3",
  },
  {
    word: "proved",
    means: messages.reasonHoldsAtEvery,
    lesson: "e4",
  },
  {
    word: "no gap seen",
    means: messages.piecesComeSoClose,
    lesson: "e5",
  },
  {
    word: "gap",
    means: messages.widestStepYouCannot,
    lesson: "e9",
  },
  {
    word: "1/600",
    means: messages.resolutionVerdictFrondDoes,
    lesson: "e5",
  },
  {
    word: "u and v",
    means: messages.uSaysHowFar,
    lesson: "e7",
  },
  {
    word: "the locus",
    means: messages.pictureAllShapesBetween,
    lesson: "e7",
  },
  {
    word: "path",
    means: messages.lineFromToB,
    lesson: "e7",
  },
  {
    word: "M",
    means: messages.locusAllShapesWith,
    lesson: "e8",
  },
  {
    word: "address",
    means: messages.digitsLeadToPiece,
    lesson: "e16",
  },
];
