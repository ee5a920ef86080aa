import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To say what it means that two pieces touch, and to tell touching from being near.",
  mistakes: [
    "“They touch if one sees no gap.” A gap may be narrower than any line on the screen. Touching means that there is a point that belongs to both.",
    "“One point is too little.” It is enough: the gasket hangs together by single points.",
    "“A shape is in one piece only if each of its pieces touches each other one.” It is enough that one can walk from piece to piece.",
  ],
  questions: [
    {
      ask: "Piece 1 has scale 0.3 and piece 2 has scale 0.6. How wide is the gap between them along the bottom edge?",
      answer: "0.1 of the side: what is left of 1 after 0.3 and 0.6.",
    },
    {
      ask: "All three pieces have the same scale. Which one makes them touch in single points?",
      answer: "½. Below it they are apart, above it they overlap.",
    },
    {
      ask: "May two pieces touch in a point in which no corner of theirs lies?",
      answer: "Yes, in other shapes: the two halves of the twin-dragon have a whole curve in common.",
    },
  ],
  answer:
    "At 0.4: along the bottom edge piece 1 reaches from 0 to its scale, and piece 2, which is 0.6 wide, begins at 0.4.",
  solutions: [
    "0.65 for both: 0.35 + 0.65 = 1. Pieces 2 and 3 then overlap.",
    "0.55: piece 3 has to reach piece 1, and 0.45 + 0.55 = 1. Pieces 1 and 2 hang together by way of piece 3.",
  ],
  onPaper: [
    {
      ask: "Piece 1 has scale 0.35. Which scales must the other two have, so that piece 1 touches each of them in one point? Draw the three triangles. Do pieces 2 and 3 touch then, or overlap?",
      space: "squares",
      answer:
        "0.65 for both: 0.35 + 0.65 = 1. Along the right side 0.65 + 0.65 is more than 1: pieces 2 and 3 overlap.",
    },
    "same",
  ],
};
