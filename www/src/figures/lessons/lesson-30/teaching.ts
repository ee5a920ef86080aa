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
  onPaper: [
    {
      ask: "A map takes 0.5 of what is across and of what is up, and pushes to the side by 2 times what was up. Follow the point (0, 1) for four steps and draw where it goes. After which step is it farthest from the middle?",
      space: "squares",
      answer: "(2, 0.5), (2, 0.25), (1.5, 0.125), (1, 0.0625). It is farthest after the first step: 2.06.",
    },
    {
      ask: "Map A takes (x, y) to (x/2 + y, y/2), map B takes (x, y) to (x/2, x + y/2). Begin at (0, 1) and take A, B, A, B. How far is the point from the middle after the second and after the fourth step? And if A is taken four times?",
      answer:
        "(1, 0.5), (0.5, 1.25), (1.5, 0.625), (0.75, 1.8125): 1.35 and 1.96 times as far as at the start. By A alone it is at (0.5, 0.0625) after four steps.",
    },
  ],
};
