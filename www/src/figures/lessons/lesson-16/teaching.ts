import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To name any piece by its digits and any point by digits without end, and to see why some points have two names.",
  mistakes: [
    "“The last digit says which big piece.” The first does: an address goes from large to small, like 13 Main Street read backwards.",
    "“1(2) is piece 12.” It is one point of it: the digits never end.",
    "“Two names mean a mistake.” They mean that two pieces share the point, as 0.4999… and 0.5 are one number.",
  ],
  questions: [
    { ask: "How many pieces have an address of four digits?", answer: "3 · 3 · 3 · 3 = 81." },
    { ask: "Which corner is (3)?", answer: "The top: it is in piece 3, in its piece 3, and so on." },
    {
      ask: "In a dust whose pieces do not meet, how many addresses has a point?",
      answer: "Exactly one: at each size it is in one piece only.",
    },
  ],
  answer: "B, the middle of the bottom: in piece 1, and then always to the right. 2(1) is the same point.",
  solutions: [
    "1(3), or 3(1): the middle of the left side is where pieces 1 and 3 touch.",
    "(12): one third is two thirds of the left half, and that is one third of the right half of it.",
    "31(2) and 32(1).",
  ],
  onPaper: ["same", "same", "same"],
};
