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
  onPaper: [
    {
      ask: "Three pieces with scales 0.52, 0.42 and 0.28 lie in the corners of a triangle of side 1. Work out the three distances, and the gap. Which scale must piece 3 have for a gap of 0.10?",
      space: "picture",
      answer: "0.06, 0.20 and 0.30: the gap is 0.20. With 0.38 piece 3 is 0.10 from piece 1.",
    },
    {
      ask: "The scales are 0.52, 0.42 and 0.28 again. You may change one of them. Which one closes the gap by the least change, and how large must it be?",
      answer:
        "Piece 1: at 0.72 it reaches both others, a change of 0.20. Each of the others would have to grow by 0.30.",
    },
  ],
};
