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
};
