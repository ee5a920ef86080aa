import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To say what it means that a map shrinks, and to tell a map that brings every point home from one that does not.",
  mistakes: [
    "A map that makes some length longer cannot lead inwards. What counts is the long run, not the first step.",
    "At scale 1 the points still come nearer, only slowly. They stay exactly as far as they are.",
    "If each of two maps alone brings all points home, so do both together. By turns they may lead away.",
  ],
  questions: [
    {
      ask: "A map has scale 0.9. After how many steps is every point nearer than half of what it was?",
      answer: "After 7: 0.9 to the power of 7 is 0.478, to the power of 6 it is 0.531.",
    },
    {
      ask: "Why can no bounded shape of more than one point be a copy of itself by a map of scale 2?",
      answer:
        "Two of its points as far apart as any would have copies twice as far apart, within the same shape.",
    },
    {
      ask: "A map halves what is across and makes what is up 1.1 times as long. Does it bring all points home?",
      answer: "No: a point straight above the middle goes away, by a tenth more with each step.",
    },
  ],
  answer:
    "Away for two steps, to 1.84 times as far, and then into the middle: in the long run only the scale counts.",
  solutions: [
    "A scale below 1, and enough push: scale 0.8 and push 2, for example. In the long run only the scale counts.",
    "A and B by turns, A first: what A moves across, B pushes up by. Each pair of steps makes the point larger.",
  ],
};
