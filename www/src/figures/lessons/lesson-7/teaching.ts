import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To see a morph as a way across a map of shapes, and that another way may hold together where the straight one breaks.",
  mistakes: [
    "“If both ends are in one piece, all between them is.” Here it is not.",
    "“The straight way is the natural one.” It is one choice: turning and moving in step.",
    "“A longer way is worse.” Length on the map does not matter; the widest gap on the way does.",
  ],
  questions: [
    {
      ask: "What do u and v say of a shape between A and B?",
      answer: "How far its maps have turned and stretched (u), and how far they have moved (v).",
    },
    { ask: "Where on the map are A and B?", answer: "At (0, 0) and (1, 1)." },
    {
      ask: "May a way go outside of the square from 0 to 1?",
      answer: "Yes: there, too, each point is a shape.",
    },
  ],
  answer:
    "At t = 0.55, and again from 0.58 to 0.70: the pieces have turned far enough to let go, and have not yet moved to where they would meet again.",
  solutions: ["u = 0.5, v = 0.1, for example.", "u = 0.2, v = 0.45, for example."],
  onPaper: [
    {
      ask: "A morph goes from A = (0, 0) over the waypoint (0.2, 0.45) to B = (1, 1), straight on both parts. Draw the way with u across and v up. Which v has it where u is 0.1, and where u is 0.6?",
      space: "squares",
      answer: "0.225, half of the way to the waypoint, and 0.725, half of the way on from there to B.",
    },
    {
      ask: "On the straight way u and v are equal. On which side of it does a morph turn first and move later? Give a point of this side, and one of the other.",
      answer:
        "Below it, where u is more than v: (0.5, 0.1), for example. Above it, as at (0.2, 0.45), it moves first.",
    },
  ],
};
