import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To bound a question from both sides by one number: a dimension that is too small for one piece, or too large for dust.",
  mistakes: [
    "“Moran’s equation always gives the dimension.” Only where the pieces do not overlap; else the true one may be less.",
    "“Dust has dimension 0.” It may have any dimension below that of the space it lies in.",
    "“Between the two circles half of the shapes are in one piece.” Nothing is said about them: size alone does not tell.",
  ],
  questions: [
    {
      ask: "Which dimension has a dust of two pieces of size ¼?",
      answer: "½: two times the square root of ¼ is 1.",
    },
    {
      ask: "A shape has three equal pieces in the plane. From which size on can it no longer be that they are all apart?",
      answer: "From 0.577, one over the root of 3, on: three times its square is 1.",
    },
    {
      ask: "Why can what is in one piece not have a dimension below 1?",
      answer:
        "Measure from one of its points how far the others are: in one piece, all distances up to some length occur, and these are a whole interval, which has dimension 1.",
    },
  ],
  answer:
    "From 0.7071 on: there 2 · |s|² is 1, so a dust would have dimension 2, and beyond it more than the plane has.",
  solutions: [
    "0.63: its third power is ¼.",
    "0.80: the third power of 0.7937 is ½, and 0.79 is still below it.",
  ],
  onPaper: ["same", "same"],
};
