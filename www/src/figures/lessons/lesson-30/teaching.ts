import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To tell a map that shrinks by some ruler from one that does not by any, and to see why the ruler may be chosen.",
  mistakes: [
    "“A map that makes some length longer cannot lead inwards.” What counts is the long run, not the first step.",
    "“If each of two maps alone brings all points home, so do both together.” By turns they may lead away.",
    "“Another ruler is a trick.” What is nearer and nearer by one ruler is so by the other: each is at most some fixed number of times the other.",
  ],
  questions: [
    {
      ask: "A map halves what is across and makes what is up 1.1 times as long. Is there a ruler by which it shrinks?",
      answer:
        "No: a point straight above the middle goes away, by a tenth more with each step, by any ruler.",
    },
    {
      ask: "The map of the question is done twice. How much can it lengthen?",
      answer:
        "It is then 0.36 of everything and a push of 1.8, and makes some lengths 1.87 times as long: still longer.",
    },
    {
      ask: "Count across plus 10 times up instead of 5. What does each step of the map of the question leave, at most?",
      answer: "0.75: of what is up, 0.6 times 10 and the push of 1.5 are 7.5 of 10.",
    },
  ],
  answer:
    "Away for two steps, to 1.84 times as far, and then into the middle: in the long run only the scale counts.",
  solutions: [
    "A scale below 1, and enough push: scale 0.8 and push 2, for example. In the long run only the scale counts.",
    "A and B by turns, A first: what A moves across, B pushes up by. Each pair of steps makes the point larger.",
  ],
};
