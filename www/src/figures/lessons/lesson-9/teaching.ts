import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To find the gap of a shape of three pieces: the widest step that cannot be avoided.",
  mistakes: [
    "“The gap is the least distance.” That may be 0 while one piece stands alone.",
    "“The gap is the largest distance.” That step can be avoided by way of another piece.",
    "“A shape whose gap is small is nearly in one piece, so it is in one piece.” However small, it is in infinitely many parts.",
  ],
  questions: [
    {
      ask: "Three pieces are 3, 4 and 6 apart. What is the gap?",
      answer: "4: steps of 3 and 4 reach all of them.",
    },
    {
      ask: "How many steps does one need to reach all of ten pieces?",
      answer: "Nine: a tree of ten dots has nine lines.",
    },
    {
      ask: "The gap of a shape is 0. What does that say?",
      answer: "That it is in one piece: pieces are closed, so a distance of 0 means a common point.",
    },
  ],
  answer:
    "0.20, the one in the middle: with steps of 0.06 and 0.20 all pieces are reached, and nobody need take the step of 0.30.",
  solutions: [
    "0.38: piece 3 is then 0.10 from piece 1.",
    "Scale 0.72 for piece 1: it reaches both others, and changes by 0.20. Piece 3 alone would have to grow by 0.30.",
  ],
};
