import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To see that a morph is not given by its two ends: which piece becomes which has to be said, and decides much.",
  mistakes: [
    "“There is one right pairing.” There are as many as orders: six for three pieces.",
    "“The pairing changes the ends.” It changes only what lies between them.",
    "“The pieces that look alike should be paired.” That may be just the pairing that breaks.",
  ],
  questions: [
    { ask: "How many pairings are there for two shapes of four pieces?", answer: "4 · 3 · 2 · 1 = 24." },
    {
      ask: "Two pairings of the same two shapes: what do their maps of shapes share?",
      answer: "The shapes at (0, 0) and at (1, 1).",
    },
    { ask: "If every way of a pairing breaks, what is left to do?", answer: "To choose another pairing." },
  ],
  answer:
    "Q: each piece becomes the one that lies as it does itself, and no two have to change places. For P and R no way was found that does not break; that none is found does not prove that there is none.",
  solutions: [
    "1 to 1, 2 to 3, 3 to 2; or 1 to 3, 2 to 2, 3 to 1.",
    "1 to 2, 2 to 3, 3 to 1: its best way opens a gap of 0.3% only.",
  ],
  onPaper: [
    {
      ask: "Write down all ways to pair three pieces with three. In which of them does exactly one piece keep its number, and in which none?",
      answer:
        "123, 132, 213, 321, 231 and 312. One keeps its number in 132, 213 and 321, none in 231 and 312.",
    },
    {
      ask: "Two shapes have four pieces each. How many pairings are there? In how many of them does piece 1 become piece 1? In how many do pieces 1 and 2 change places, and the others keep their numbers?",
      answer: "24; six; one.",
    },
  ],
};
