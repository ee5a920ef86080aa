import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To tell a proof from a picture: to say why two curves whose ends take turns must meet, and why pieces that only look so need more.",
  mistakes: [
    "That two shapes which lie over each other in a picture share a point. Each may pass through the gaps of the other.",
    "That a finer picture settles it. Every picture has a finest detail, and a gap may be finer.",
    "That it matters which sides of the square the ends are on. Only their order round the border does.",
  ],
  questions: [
    {
      ask: "Is it still so in space, for two curves in a cube?",
      answer: "No. One passes in front of the other: there is room to go round.",
    },
    {
      ask: "Why is a piece of a shape no curve?",
      answer: "It may be in pieces itself, and that it is not is just what is to be proved.",
    },
    {
      ask: "The widest gap is said to be g. Why are the gaps within a piece narrower?",
      answer:
        "A piece is the whole, made smaller by a factor below 1 (in a suitable norm), and so are its gaps.",
    },
  ],
  answer:
    "No, though no picture shows it: a piece may have gaps, and another one may go through them. That two pieces lie across each other is no proof.",
  solutions: [
    "One end of B on the short way between the ends of A, over the lower left corner; the other one anywhere else.",
    "One end of B on the right side below the end of A, the other one above it: they take turns on the border.",
  ],
  onPaper: [
    {
      ask: "Go once round a square. The ends of two curves in it come in this order: a) A, B, A, B; b) A, A, B, B; c) A, B, B, A. Which of them must meet? Draw the others so that they do not.",
      space: "squares",
      answer:
        "Only a. In b and c the two ends of A stand next to each other round the square, and so do those of B.",
    },
    {
      ask: "A curve A goes from the left side of a square to the right one. Draw a curve B with both ends on the right side that must meet A, and another one that need not.",
      space: "squares",
      answer: "One end of B below that of A and the other one above it; both ends on one side of it.",
    },
  ],
};
