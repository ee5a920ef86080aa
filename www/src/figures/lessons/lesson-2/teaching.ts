import type { Teaching } from "../frame/teaching";

export const TEACHING: Teaching = {
  aim: "To play the chaos game, and to explain why it leaves the same parts empty however one throws.",
  mistakes: [
    "“Chance fills everything in the end.” The die chooses the corner, but where one can land is settled by the rule.",
    "“The first throw decides in which large part one is.” It is the last one: each throw moves all that was before into one half.",
    "“Another die makes another shape.” Uneven dice leave marks more often here than there, but not elsewhere.",
  ],
  questions: [
    {
      ask: "The last three throws were towards 1, 2 and 3, in this order. In which small triangle is the mark?",
      answer:
        "In piece 3, there in its piece 2, and there in its piece 1: the last throw is the first digit.",
    },
    {
      ask: "A throw goes half of the way. How much nearer to each other are two marks that are thrown towards the same corner?",
      answer: "Half as far apart as before. After ten such throws it is less than a thousandth.",
    },
    {
      ask: "Does it matter where one begins?",
      answer: "For the first few marks. Their distance from the gasket is halved at least with every throw.",
    },
  ],
  answer:
    "A triangle in the middle, and those in the middles of the halves, and theirs: a throw ends in the half-size triangle at its corner, and the middle is in none of the three.",
  solutions: [
    "First towards 3, then towards 2: the last throw chooses the large triangle, the one before it the small one within.",
    "0.6 of the way: then the scale of the pieces is 0.4, and 1 − 2 · 0.4 = 0.2.",
  ],
  onPaper: [
    {
      ask: "Which two throws bring a mark into the framed triangle, the top part of the piece at the lower right, wherever it was before? Which comes first, and why?",
      space: "picture",
      answer:
        "First towards 3, then towards 2: the last throw chooses the large triangle, the one before it the small one within.",
    },
    {
      ask: "Jump 0.6 of the way instead of half of it. How large is each of the three parts, and how wide is the gap between two of them, on a side of length 1? How far must one jump for a gap of 0.5?",
      answer:
        "Each part is 0.4 as large as the whole, and 1 − 2 · 0.4 = 0.2 is left. For a gap of 0.5 one jumps 0.75 of the way.",
    },
  ],
};
